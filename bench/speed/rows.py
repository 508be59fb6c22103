"""From records of runs to the rows of bench/results/speed.json."""

from statistics import median

from measuring import DISTURBED
from statistics_of_rates import ratios, spread
from whole_case import hours

CLOCK, PROCESSOR = "rate", "processor_rate"


def good(records):
    """Records that have a rate."""
    return [record for record in records or [] if record and CLOCK in record]


def row_of(records):
    """Spread of the rates of one contender, or why there is none."""
    runs = good(records)
    if not runs:
        failed = [record["failed"] for record in records or [] if record]
        return {"failed": failed[0]} if failed else {"not_available": True}
    row = {"particles": runs[0]["particles"], "steps": runs[0]["steps"], CLOCK: spread(run[CLOCK] for run in runs)}
    if all(run.get(PROCESSOR) for run in runs):
        row[PROCESSOR] = spread(run[PROCESSOR] for run in runs)
    row |= {name: runs[-1].get(name) for name in ("coordination", "kinetic_energy", "skin") if runs[-1].get(name) is not None}
    row["disturbed_runs"] = sum(run["others"] > DISTURBED for run in runs)
    return row


def paired(ours, theirs, kind=CLOCK):
    """Ratios of the runs of the same round."""
    pairs = [(a[kind], b[kind]) for a, b in zip(ours or [], theirs or []) if good([a]) and good([b]) and a.get(kind) and b.get(kind)]
    return ratios(*zip(*pairs)) if pairs else None


def case_rows(cases, contenders, records):
    """One row for each case: every contender's rate, and our ratio to it, by the clock and by processor time."""
    rows = []
    ours = [contender.name for contender in contenders if contender.name == "recoat" or contender.name.startswith("recoat, ")]
    for case in cases:
        found = {contender.name: records.get((str(case), contender.name)) for contender in contenders if contender.takes(case)}
        row = {"scene": case.scene, "bond_number": case.bond, "threads": case.threads}
        row["rates"] = {name: row_of(runs) for name, runs in found.items()}
        measured = [mine for mine in ours if good(found.get(mine))]
        others = [other for other in found if other not in ours]
        for name, kind in (("ratios", CLOCK), ("processor_ratios", PROCESSOR)):
            row[name] = {mine: {other: paired(found[mine], found[other], kind) for other in others} for mine in measured}
        rows.append(row)
    return rows


def skipped_rows(plan, records):
    """What each thing costs: the ratio of the rates without it and with it."""
    rows = []
    for row in plan:
        sides = [records.get((row["what"], side)) for side in ("without", "with")]
        ratio = paired(*sides, kind=PROCESSOR)
        rows.append({"what": row["what"], "with": row_of(sides[1]), "without": row_of(sides[0]), "gain": ratio})
    return rows


def whole_rows(bonds, names, predictions, pieces):
    """Hours of processor time of a case of the paper, by `check` and by a piece of the heap, and today's share of the former commit's."""
    rows = []
    for bond in bonds:
        programs = {}
        for name in names:
            checks = [record for record in predictions[bond, name] if "rate" in record]
            runs = good(pieces.get((bond, name)))
            if not checks or not runs:
                programs[name] = {"failed": "; ".join(str(record) for record in predictions[bond, name])[:300]}
                continue
            rate = median(record["rate"] for record in checks)
            piece = median(run[PROCESSOR] for run in runs)
            entry = {key: checks[0][key] for key in ("time_step", "steps", "spread_steps", "bytes_per_particle")}
            entry |= {"check_rate": rate, "check_hours": hours(checks[0], rate)}
            entry |= {"piece_rate": piece, "piece_hours": hours(checks[0], piece), "piece_time_step": runs[0]["time_step"]}
            programs[name] = entry
        rows.append({"bond_number": bond, "programs": programs, "share_of_former": shares([programs[name] for name in names])})
    return rows


def shares(entries):
    """Today's hours over those of the former commit."""
    if len(entries) < 2 or any("check_hours" not in entry for entry in entries):
        return None
    today, former = entries
    return {kind: today[f"{kind}_hours"]["spreading"] / former[f"{kind}_hours"]["spreading"] for kind in ("check", "piece")}
