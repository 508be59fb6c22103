"""Scalar metrics of every layer with the 95 % interval of a block bootstrap along x, one row per case.

Intervals are those of the report where it has them; the others are made with the same resamples.
"""

import numpy
import pandas

from extremes import PAPER_AREA, prediction
from layer_metrics import scalars
from layers import by_case, load_layers
from reporting import logged, write_text

def cluster_sizes(layer):
    """Of the clusters of the region, single particles among them; what lies across its ends counts as a whole."""
    clusters = layer.metrics["clusters"]
    sizes = numpy.array(list(map(int, clusters["size_fraction"])), dtype=int)
    numbers = clusters["n_particles"] * numpy.array(list(clusters["size_fraction"].values())) / numpy.maximum(sizes, 1)
    return numpy.repeat(sizes, numpy.maximum(numpy.rint(numbers), 1).astype(int))


def pore_sizes(layer):
    """Diameters of the density pores [d_p]."""
    return numpy.array([pore["diameter"] for pore in layer.density_pores], dtype=float)


def extremes(replicates):
    """The largest cluster and density pore of a layer of the paper's size, as all replicates of a case foresee them."""
    area = sum((layer.x_range[1] - layer.x_range[0]) * layer.width for layer in replicates)
    result = {"extremes_area": area}
    for name, sizes in (("largest_cluster", cluster_sizes), ("pore_largest_dp", pore_sizes)):
        found = prediction(numpy.concatenate([sizes(layer) for layer in replicates]), area, PAPER_AREA)
        lower, middle, upper = found or (numpy.nan,) * 3
        result |= {f"{name}_paper": middle, f"{name}_paper_lower": lower, f"{name}_paper_upper": upper}
    return result


def table(layers):
    """One row per case; the columns NAME, NAME_lower, NAME_upper for every scalar."""
    rows = []
    foreseen = {case: extremes(replicates) for case, replicates in by_case(layers).items()}
    for layer in layers:
        row = {"bond_number": layer.bond, "stiffness_ratio": layer.ratio, "seed": layer.seed}
        for name, (value, lower, upper) in scalars(layer).items():
            row |= {name: value, f"{name}_lower": lower, f"{name}_upper": upper}
        rows.append(row | foreseen[layer.bond, layer.ratio])
    return pandas.DataFrame(rows)


if __name__ == "__main__":
    with logged(snakemake):
        write_text(snakemake.output[0], table(load_layers(snakemake)).to_csv(index=False, float_format="%.8g"))
