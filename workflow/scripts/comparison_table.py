"""The paper's statements beside what this grid gives, and what it would take where that cannot be told; not tuned."""

import math

import pandas

from reporting import logged, read_json, write_text
from statements import evaluate
from verdicts import UNKNOWN

COLUMNS = ["figure", "paper says", "this grid gives", "verdict", "it would take"]
MOST = 1e4  # times the layers that there are: what takes more is not to be seen by any layer


def processor_hours(runtime, bonds, ratio):
    """What the layers of some Bond numbers have taken, all seeds together; 0 where that is not known."""
    rows = runtime[(runtime["stage"] == "all") & runtime["bond_number"].isin(bonds) & (runtime["stiffness_ratio"] == ratio)]
    return (rows["wall_seconds"] * rows["threads"]).sum() / 3600


def effort(judgement, runtime, ratio):
    """How much more layer would decide a statement, as text."""
    if judgement.verdict != UNKNOWN or not judgement.more > 0:
        return ""
    if judgement.more > MOST:
        return "no difference is seen that a larger layer would confirm"
    text = f"{judgement.more:.2g} times as much layer, for intervals {1 / math.sqrt(judgement.more):.2g} times as wide"
    hours = judgement.more * processor_hours(runtime, judgement.bonds, ratio)
    return text + (f": {hours:.2g} h of a core" if hours > 0 else "")


def table(rows, runtime, ratio):
    """The comparison as it is written."""
    texts = [(figure, says, j.found, j.verdict, effort(j, runtime, ratio)) for figure, says, j in rows]
    return pandas.DataFrame(texts, columns=COLUMNS)


if __name__ == "__main__":
    with logged(snakemake):
        tables = (pandas.read_csv(snakemake.input[name]) for name in ("metrics", "beds", "energy", "runtime"))
        metrics, beds, energy, runtime = tables
        scenes = zip(snakemake.params.cases, map(read_json, snakemake.input.derived), strict=True)
        derived = {case["bond"]: scene["inertial_length"]["paper"] for case, scene in scenes}
        ratio = snakemake.params.reference_ratio
        rows = evaluate(metrics, beds, ratio, derived, energy)
        write_text(snakemake.output[0], table(rows, runtime, ratio).to_csv(index=False))
