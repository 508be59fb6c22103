"""Global packing density of every packed bed [paper, eq. 14], one row per case."""

import pandas

from layers import bed_density, load_layers
from reporting import logged, write_text


def table(beds):
    """eq14_clipped cuts the spheres at 0.9 z_max; the other two forms take whole spheres."""
    rows = []
    for bed in beds:
        value, lower, upper = bed_density(bed)
        totals = bed.metrics["totals"]
        rows.append(
            {
                "bond_number": bed.bond,
                "stiffness_ratio": bed.ratio,
                "seed": bed.seed,
                "packing_density": value,
                "packing_density_lower": lower,
                "packing_density_upper": upper,
                "eq14_centre": totals["eq14_centre"],
                "eq14_all": totals["eq14_all"],
                "coordination_number_mean": bed.metrics["clusters"]["cn_mean"],
            }
        )
    return pandas.DataFrame(rows)


if __name__ == "__main__":
    with logged(snakemake):
        write_text(snakemake.output[0], table(load_layers(snakemake)).to_csv(index=False, float_format="%.8g"))
