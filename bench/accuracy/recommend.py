"""The longest step whose error is below 1 % in the capture velocity and below the scatter of replicates."""

from statistics_of_runs import pooled

CAPTURE_LIMIT = 0.01  # worst phase, pair and wall
ENERGY_LIMIT = 0.01  # of the blade's work, or of what the fill dissipates
REFERENCE_STEP = 5e-8  # steps up to it are the reference of longer ones
SCHEME = "discrete_gradient"
PAPER_RATIO = 0.001


def longest_before_failure(rows, good):
    """The last step of the rows, in rising order, before one that is not good; None if the first is not."""
    longest = None
    for row in sorted(rows, key=lambda row: row["time_step"]):
        if not good(row):
            return longest
        longest = row["time_step"]
    return longest


def capture_is_good(row):
    """Whether the worst phases of pair and wall are below the limit."""
    worst = [row["errors"][f"capture velocity, {kind}"]["worst"] for kind in ("pair", "wall")]
    return all(error is not None and abs(error) < CAPTURE_LIMIT for error in worst)


def shift(entry, reference):
    """Largest distance of a quantity from the reference, in scatters of replicates, and its name."""
    shifts = {}
    for name, found in entry["quantities"].items():
        usual = pooled(reference, name)
        if usual and usual["scatter"] > 0 and found["mean"] is not None:
            shifts[name] = abs(found["mean"] - usual["mean"]) / usual["scatter"]
    name = max(shifts, key=shifts.get)
    return {"quantity": name, "scatters": shifts[name]}


def powder_rows(entries):
    """Steps of one kind of run and Bond number, with their distance from the shorter ones."""
    reference = [entry for entry in entries if entry["time_step"] <= REFERENCE_STEP]
    return [
        {
            "time_step": entry["time_step"],
            "faults": entry["faults"],
            "energy_balance_error": entry.get("energy_balance_error"),
            "shift": shift(entry, reference) if "quantities" in entry else None,
        }
        for entry in entries
    ]


def powder_is_good(row):
    """No fault, energy accounted for, and no quantity further off than replicates are from each other."""
    if row["faults"] or row["energy_balance_error"] >= ENERGY_LIMIT:
        return False
    return row["time_step"] <= REFERENCE_STEP or row["shift"]["scatters"] < 1


def gain_at_equal_error(two_body):
    """For each Bond number at the ratio of the paper: what each scheme costs at its longest step within the limit.

    `processor_seconds`: of a millisecond of a thousand particles; `gain`: that over what the default scheme costs.
    """
    rows = []
    for case in two_body:
        longest = longest_before_failure(case["steps"], capture_is_good)
        if case["ratio"] != PAPER_RATIO or longest is None:
            continue
        seconds = next(row["processor_seconds"] for row in case["steps"] if row["time_step"] == longest)
        own = {"bond": case["bond"], "scheme": case["scheme"]}
        rows.append(own | {"longest_step": longest, "processor_seconds": seconds})
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
        "limits": {"capture_velocity": CAPTURE_LIMIT, "energy_balance": ENERGY_LIMIT, "scatters": 1},
        "two_body": sorted(bodies, key=lambda row: (row["bond"], row["ratio"])),
        "powder": beds_and_layers,
    }
