"""The paper's statements beside what this grid gives; computed, not tuned."""

import pandas

from reporting import logged, read_json, write_text
from statements import evaluate

COLUMNS = ["figure", "paper says", "this grid gives", "verdict"]

if __name__ == "__main__":
    with logged(snakemake):
        metrics = pandas.read_csv(snakemake.input.metrics)
        beds = pandas.read_csv(snakemake.input.beds)
        scenes = zip(snakemake.params.cases, map(read_json, snakemake.input.derived), strict=True)
        derived = {case["bond"]: scene["inertial_length"]["paper"] for case, scene in scenes}
        rows = evaluate(metrics, beds, snakemake.params.reference_ratio, derived)
        write_text(snakemake.output[0], pandas.DataFrame(rows, columns=COLUMNS).to_csv(index=False))
