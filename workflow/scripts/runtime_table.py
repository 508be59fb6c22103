"""Steps, wall time and speed of every stage of every run."""

import pandas

from reporting import logged, read_json, write_text


def table(cases, summaries):
    """One row per stage, and one for the whole run."""
    rows = []
    for case, summary in zip(cases, summaries, strict=True):
        common = {
            "bond_number": case["bond"],
            "stiffness_ratio": case["ratio"],
            "seed": case["seed"],
            "particles": summary["particles"],
            "threads": summary["threads"],
            "time_step_s": summary["time_step"],
            "version": summary["version"],
            "backend": summary.get("backend", ""),
            "instruction_set": summary.get("instruction_set", ""),
        }
        for stage in summary["stages"]:
            rows.append(
                common
                | {
                    "stage": stage["name"],
                    "steps": stage["steps"],
                    "wall_seconds": stage["wall_seconds"],
                    "particle_steps_per_second": stage["particle_steps_per_second"],
                }
            )
        steps = sum(stage["steps"] for stage in summary["stages"])
        rows.append(
            common
            | {
                "stage": "all",
                "steps": steps,
                "wall_seconds": summary["wall_seconds"],
                "particle_steps_per_second": steps * summary["particles"] / max(summary["wall_seconds"], 1e-9),
            }
        )
    return pandas.DataFrame(rows)


if __name__ == "__main__":
    with logged(snakemake):
        summaries = [read_json(path) for path in snakemake.input.summaries]
        write_text(
            snakemake.output[0], table(snakemake.params.cases, summaries).to_csv(index=False, float_format="%.6g")
        )
