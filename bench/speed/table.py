"""Writes the tables of docs/performance.md, and the sentence of the README, from bench/results/speed.json.

usage: bench/speed/table.py [RESULT.json] [--print]   (between the comments "begin: speed" and "end: speed" of both files)
"""

import argparse
import json
import re
from pathlib import Path

from machine import ROOT

RESULT = ROOT / "bench/results/speed.json"
NAMES = {"bed": "settled bed, 10,000", "large_bed": "settled bed, 100,000", "heap": "heap before the blade", "layer": "sparse layer, at rest"}
KINDS = {"double": "double", "mixed": "single"}  # of the arithmetic of a precision's laws
COUNTS = {
    "instructions": "instructions (AVX2)",
    "operations": "operations",
    "quotients_and_roots": "of these quotients and roots",
    "bytes_requested": "bytes requested",
    "bytes_beyond_first_cache": "from beyond 32 KiB",
    "bytes_beyond_second_cache": "from beyond 512 KiB",
}


def millions(row, kind="rate"):
    """Median rate in 1e6 per second with its spread, or why there is none."""
    if not row:
        return "-"
    if "rate" not in row:
        return "fails" if "failed" in row else "not available"
    if kind not in row:
        return "-"
    rate = row[kind]
    return f"{rate['median'] / 1e6:.2f} ({rate['least'] / 1e6:.2f} to {rate['largest'] / 1e6:.2f})"


def missing(result):
    """What could not be measured here."""
    names = dict.fromkeys(name for row in result["side_by_side"] for name in row["rates"])
    without = [name for name in names if name not in names_of(result["side_by_side"])]
    return f" Not available: {'; '.join(without)}." if without else ""


def ratio(value):
    return f"{value['median']:.2f} ({value['least']:.2f} to {value['largest']:.2f})" if value else "-"


def table(head, rows):
    return "\n".join(f"| {' | '.join(map(str, row))} |" for row in [head, ["---"] * len(head), *rows])


def names_of(rows):
    """Contenders in the order of the rows, those that no program here can be left out."""
    names = list(dict.fromkeys(name for row in rows for name in row["rates"]))
    return [name for name in names if any("not_available" not in row["rates"].get(name, {"not_available": 1}) for row in rows)]


def rates(result, threads):
    """By the clock; of one thread on a busy machine by processor time."""
    rows = [row for row in result["side_by_side"] if row["threads"] == threads]
    names, by_processor = names_of(rows), threads == 1 and bool(busy(result))
    kind = "processor_rate" if by_processor else "rate"
    lines = [[NAMES[row["scene"]], f"{row['bond_number']:g}", *(millions(row["rates"].get(name), kind) for name in names)] for row in rows]
    return table([f"10^6 particle-steps per {'processor ' if by_processor else ''}second", "Bo", *names], lines)


def kind_of_ratio(result):
    """By the clock; on a busy machine by processor time."""
    return ("processor_ratios", "by processor time") if busy(result) else ("ratios", "by the clock")


def lead(result):
    """Our rate over that of the others, on one core."""
    rows = [row for row in result["side_by_side"] if row["threads"] == 1]
    kind, how = kind_of_ratio(result)
    others = list(dict.fromkeys(other for row in rows for ours in row[kind].values() for other in ours))
    lines = []
    for row in rows:
        for mine, ratios in row[kind].items():
            lines.append([NAMES[row["scene"]], f"{row['bond_number']:g}", mine, *(ratio(ratios.get(other)) for other in others)])
    return table([f"our rate, {how}, over that of", "Bo", "ours", *others], lines)


def scaling(result):
    """Two threads over one, and what cohesion and size cost."""
    by_case = {(row["scene"], row["bond_number"], row["threads"]): row["rates"] for row in result["side_by_side"]}

    def over(name, case, other):
        kind = "processor_rate" if busy(result) and case[2] == other[2] else "rate"
        pair = [by_case.get(key, {}).get(name, {}).get(kind) for key in (case, other)]
        return f"{pair[0]['median'] / pair[1]['median']:.2f}" if all(pair) else "-"

    bonds = sorted({bond for _, bond, _ in by_case})
    names = [name for name in names_of(result["side_by_side"]) if name == "recoat" or name.startswith("recoat, ")]
    lines = []
    for name in names:
        for bond in bonds:
            two = [over(name, (scene, bond, 2), (scene, bond, 1)) for scene in NAMES]
            lines.append([name, f"{bond:g}", *two, over(name, ("large_bed", bond, 1), ("bed", bond, 1)), over(name, ("bed", bond, 1), ("bed", 0, 1))])
    return table(["", "Bo", *(f"two threads over one: {text}" for text in NAMES.values()), "100,000 over 10,000", "bed: over Bo 0"], lines)


def bounds(result):
    """What a step needs, and the share of what the machine gives that this is at the measured rate."""
    limits = result["limits"][0]
    by_case = {(row["scene"], row["bond_number"]): row["rates"] for row in result["side_by_side"] if row["threads"] == 1}
    lines = []
    for row in result["counts"]:
        rates_of_case = by_case.get((row["scene"], row["bond_number"]), {})
        name, kind = (f"recoat, {row['precision']}", KINDS[row["precision"]]) if row["precision"] else ("recoat", "double")
        ours = rates_of_case.get(name, {}).get("processor_rate", {}).get("median")
        if "instructions" not in row:
            continue
        shares = ["-", "-", "-"]
        if ours:
            shares = [f"{100 * ours * row['operations'] / limits[f'operations_{kind}_per_second']:.0f} %"]
            shares += [f"{100 * ours * row['quotients_and_roots'] / limits[f'quotients_{kind}_per_second']:.0f} %"]
            shares += [f"{100 * ours * row['bytes_beyond_first_cache'] / limits['cached_stream_bytes_per_second']:.0f} %"]
        lines.append([NAMES[row["scene"]], f"{row['bond_number']:g}", row["precision"], *(f"{row[key]:.0f}" for key in COUNTS), *shares])
    return table(["per particle-step", "Bo", "precision", *COUNTS.values(), "of peak operations", "of peak quotients", "of the stream from L2"], lines)


def skipped(result):
    lines = []
    for row in result["skipped"]:
        lines.append([row["what"], *(millions(row[side], "processor_rate") for side in ("with", "without")), ratio(row["gain"])])
    return table(["skipped", "computed, 10^6 per processor second", "skipped", "gain"], lines)


def whole(result):
    lines = []
    for row in result["whole_case"]:
        for name, entry in row["programs"].items():
            if "check_hours" not in entry:
                lines.append([f"{row['bond_number']:g}", name, "fails", *["-"] * 5])
                continue
            hours = [f"{entry[kind]['spreading']:.1f}" for kind in ("check_hours", "piece_hours")]
            sizes = [f"{entry['check_hours']['all_stages_at_most']:.0f}", f"{entry['bytes_per_particle']:.0f}"]
            lines.append([f"{row['bond_number']:g}", name, f"{entry['time_step']:.3g}", entry["spread_steps"], *hours, *sizes])
        if row["share_of_former"]:
            share = row["share_of_former"]
            lines.append([f"{row['bond_number']:g}", "today's share", "", "", f"{100 * share['check']:.0f} %", f"{100 * share['piece']:.0f} %", "", ""])
    return table(["Bo", "program", "automatic step [s]", "steps of spreading", "hours, by `check`", "hours, by the heap", "all stages at most", "bytes per particle"], lines)


def busy(result):
    """A warning where others kept the machine busy."""
    rows = [row for case in result["side_by_side"] for row in case["rates"].values() if "rate" in row]
    disturbed, runs = sum(row["disturbed_runs"] for row in rows), sum(row["rate"]["repeats"] for row in rows)
    if disturbed * 10 <= runs:
        return ""
    return f"\n\n**The machine was busy**: others kept it busy in {disturbed} of {runs} runs, so rates by the clock are too low; ratios are by processor time."


def origin(result):
    return f"`{result['command']}`, {result['date']}, {result['machine']}, commit {result['commit']}"


def limits_text(result):
    parts = []
    for limits in result["limits"]:
        giga = {key: value / 1e9 for key, value in limits.items() if key.endswith("per_second")}
        parts.append(
            f"{limits['threads']} thread(s): {giga['operations_double_per_second']:.0f} and {giga['operations_single_per_second']:.0f} 10^9 operations/s "
            f"in double and single, {giga['quotients_double_per_second']:.2f} and {giga['quotients_single_per_second']:.2f} 10^9 quotients/s, "
            f"{giga['cached_stream_bytes_per_second']:.0f} and {giga['memory_stream_bytes_per_second']:.0f} GB/s from L2 and memory"
        )
    return f"The machine at most (`machine-limits`, {result['limits'][0]['vectors']}): " + "; ".join(parts) + "."


def report(result):
    """All tables as Markdown."""
    parts = [
        f"{origin(result)}. Medians of runs that took turns, with the least and the largest.{missing(result)}{busy(result)}",
        "One core:\n\n" + rates(result, 1),
        "Two cores (threads; processes of LIGGGHTS and LAMMPS without `omp`):\n\n" + rates(result, 2),
        lead(result),
        scaling(result),
        limits_text(result),
        *([bounds(result)] if result["counts"] else []),
        "What each thing costs, on one core:\n\n" + skipped(result),
        "A case of the paper at the automatic step, in hours of processor time for the spreading of 100,000 particles over 500 d_p:\n\n" + whole(result),
    ]
    return "\n\n".join(parts)


def sentence(result):
    """The lead on the settled bed of 10,000 without cohesion, for the README."""
    row = next(row for row in result["side_by_side"] if (row["scene"], row["bond_number"], row["threads"]) == ("bed", 0, 1))
    parts = []
    kind, how = kind_of_ratio(result)
    for mine, ratios in row[kind].items():
        peers = {other: value["median"] for other, value in ratios.items() if value and not other.startswith("recoat")}
        if peers:
            rate = row["rates"][mine]["processor_rate" if busy(result) else "rate"]["median"] / 1e6
            parts.append(f"{mine}: {rate:.1f} million particle-steps/s {how}, " + ", ".join(f"{value:.1f} times {other}" for other, value in peers.items()))
    return f"On one core, a settled bed of 10,000 spheres without cohesion: {'; '.join(parts)} ({origin(result)}).{busy(result)}"


def replace(file, text):
    """Puts `text` between the marks of a file."""
    content = file.read_text()
    marked = re.compile(r"(<!-- begin: speed[^\n]*-->\n).*?(\n<!-- end: speed -->)", re.DOTALL)
    if not marked.search(content):
        raise SystemExit(f"{file}: the marks 'begin: speed' and 'end: speed' are missing; put them where the table belongs")
    file.write_text(marked.sub(lambda match: match[1] + text + match[2], content))


def main():
    parser = argparse.ArgumentParser(description="Tables of the solver's speed")
    parser.add_argument("result", nargs="?", default=RESULT)
    parser.add_argument("--print", action="store_true", help="to the terminal, instead of into the documents")
    options = parser.parse_args()
    result = json.loads(Path(options.result).read_text())
    if options.print:
        print(sentence(result), report(result), sep="\n\n")
        return
    replace(ROOT / "docs/performance.md", report(result))
    replace(ROOT / "README.md", sentence(result))


if __name__ == "__main__":
    main()
