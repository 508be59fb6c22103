"""The longest step whose error is below 1 % in the capture velocity and below the scatter of replicates; gains."""

from statistics_of_runs import mean_by_seed, pooled, student_difference

CAPTURE_LIMIT = 0.01  # worst phase, pair and wall
ENERGY_LIMIT = 0.01  # of the blade's work, or of what the fill dissipates
REFERENCE_STEP = 5e-8  # steps up to it are the reference of longer ones
CHANCE_LIMIT = 0.05  # of the most shifted of all quantities
SCHEME = "discrete_gradient"
PAPER_RATIO = 0.001


def good_before_failure(rows, good):
    """The rows in rising order of the step, up to one that is not good."""
    found = []
    for row in sorted(rows, key=lambda row: row["time_step"]):
        if not good(row):
            break
        found.append(row)
    return found


def longest_before_failure(rows, good):
    """The last step of the rows before one that is not good; None if the first is not."""
    found = good_before_failure(rows, good)
    return found[-1]["time_step"] if found else None


def capture_error(row):
    """Worst error of the capture velocity, of pair or wall; None without bound."""
    worst = [row["errors"][f"capture velocity, {kind}"]["worst"] for kind in ("pair", "wall")]
    return None if None in worst else max(map(abs, worst))


def capture_is_good(row):
    """Whether the worst phases of pair and wall are below the limit."""
    error = capture_error(row)
    return error is not None and error < CAPTURE_LIMIT


def reference_of(entry, entries):
    """What a step is held to: all shorter ones up to REFERENCE_STEP; of none, nothing."""
    return [
        other
        for other in entries
        if other["time_step"] < entry["time_step"] and other["time_step"] <= REFERENCE_STEP and "quantities" in other
    ]


def shifts(entry, reference, alike):
    """How far each quantity is from the reference: in scatters of replicates, which are taken to be the same in all
    settings that are `alike`, and in standard errors of the difference.

    The difference is between runs of the same seed where there are enough: a particle bed keeps much of its random
    placement (correlation of beds of different steps: 0.2 at Bo 5, 0.75 at Bo 400).
    """
    found = {}
    for name, own in entry["quantities"].items():
        usual = pooled(alike, name)
        if usual is None or usual["scatter"] == 0:
            continue
        other = mean_by_seed([part["quantities"][name] for part in reference])
        difference = student_difference(own["by_seed"], other, usual["scatter"])
        if difference is None:
            continue
        error = difference["standard_error"]
        found[name] = {
            "difference": difference["mean"],
            "scatters": abs(difference["mean"]) / usual["scatter"],
            "standard_errors": abs(difference["mean"]) / error if error else None,
            "chance": difference["chance"],
            "chance_beyond_scatter": difference["chance_beyond"],
            "pairs": difference["pairs"],
        }
    return found


def least_chance(found, key):
    """That of the least likely of all quantities, times their number."""
    known = [shift[key] for shift in found.values() if shift[key] is not None]
    return min(1.0, min(known) * len(known)) if known else None


def largest_shift(entry, reference, alike):
    """The quantity that is furthest off in scatters, and how likely chance makes one of so many as far off:
    `chance_of_any` if none were off at all, `chance_of_any_beyond_scatter` if all were off by one scatter."""
    found = shifts(entry, reference, alike) if "quantities" in entry else {}
    if not found:
        return None
    name = max(found, key=lambda name: found[name]["scatters"])
    return {
        "quantity": name,
        **found[name],
        "chance_of_any": least_chance(found, "chance"),
        "chance_of_any_beyond_scatter": least_chance(found, "chance_beyond_scatter"),
        "quantities": found,
    }


def powder_rows(entries):
    """Steps of one kind of run and Bond number, with their distance from the shorter ones.

    The reference of each row are the shorter steps up to REFERENCE_STEP, never the row itself; the shortest has none.
    """
    rows = []
    for entry in entries:
        reference = reference_of(entry, entries)
        rows.append(
            {
                "time_step": entry["time_step"],
                "runs": entry["runs"],
                "faults": entry["faults"],
                "energy_balance_error": entry.get("energy_balance_error"),
                "reference": [{"time_step": r["time_step"], "runs": r["runs"] - r["faults"]} for r in reference],
                "shift": largest_shift(entry, reference, [other for other in entries if "quantities" in other]),
            }
        )
    return rows


def powder_is_good(row):
    """No fault, energy accounted for, and no quantity further off than replicates are from each other.

    The mean of a few replicates of the same thing is off by a scatter now and then: further off counts what chance
    would hardly make of a shift of one scatter.
    """
    if row["faults"] or row["energy_balance_error"] >= ENERGY_LIMIT:
        return False
    chance = row["shift"] and row["shift"]["chance_of_any_beyond_scatter"]
    return chance is None or chance >= CHANCE_LIMIT


def gain_at_equal_error(two_body):
    """For each Bond number at the ratio of the paper: what each scheme costs at its cheapest step within the limit.

    The cheapest of the steps up to the longest good one: not always the longest, which may need a dearer solve of the
    pair. `processor_seconds`: of a millisecond of a thousand particles; `gain`: that over what the default scheme costs.
    """
    rows = []
    for case in two_body:
        good = good_before_failure(case["steps"], capture_is_good)
        if case["ratio"] != PAPER_RATIO or not good:
            continue
        cheapest = min(good, key=lambda row: row["processor_seconds"])
        rows.append(
            {
                "bond": case["bond"],
                "scheme": case["scheme"],
                "longest_step": good[-1]["time_step"],
                "cheapest_step": cheapest["time_step"],
                "capture_error": capture_error(cheapest),
                "processor_seconds": cheapest["processor_seconds"],
            }
        )
    usual = {row["bond"]: row["processor_seconds"] for row in rows if row["scheme"] == SCHEME}
    return [row | {"gain": row["processor_seconds"] / usual[row["bond"]]} for row in rows]


def recommended_steps(two_body, powder):
    """By bodies for every stiffness ratio, and by powder at that of the paper."""
    bodies = [
        {
            "bond": case["bond"],
            "ratio": case["ratio"],
            "longest_step": longest_before_failure(case["steps"], capture_is_good),
        }
        for case in two_body
        if case["scheme"] == SCHEME
    ]
    kinds = sorted({(entry["kind"], entry["bond"]) for entry in powder})
    beds_and_layers = []
    for kind, bond in kinds:
        rows = powder_rows([entry for entry in powder if (entry["kind"], entry["bond"]) == (kind, bond)])
        beds_and_layers.append(
            {"kind": kind, "bond": bond, "longest_step": longest_before_failure(rows, powder_is_good), "steps": rows}
        )
    return {
        "limits": {
            "capture_velocity": CAPTURE_LIMIT,
            "energy_balance": ENERGY_LIMIT,
            "scatters": 1,
            "chance_up_to_the_reference": CHANCE_LIMIT,
            "reference_step": REFERENCE_STEP,
        },
        "two_body": sorted(bodies, key=lambda row: (row["bond"], row["ratio"])),
        "powder": beds_and_layers,
    }
