"""Scalar metrics of every layer with the 95 % interval of a block bootstrap along x, one row per case.

Intervals are those of the report where it has them; the others are made with the same resamples.
"""

import numpy
import pandas

from extremes import PAPER_AREA, prediction
from layers import by_case, load_layers
from pore_metrics import pore_scalars
from reporting import logged, write_text

UNKNOWN = (numpy.nan, numpy.nan)  # extreme values and counts of the whole layer: resampling does not tell their scatter


def perpendicular(layer, sizes):
    """Group 1 for particles of clusters of these sizes at 45 degrees or more, 0 below, -1 for all others."""
    angle = layer.cluster_angle
    chosen = numpy.isin(layer.cluster_size, sizes) if sizes else layer.cluster_size > 1
    group = numpy.where(angle >= 45, 1, 0)
    return numpy.where(chosen & numpy.isfinite(angle), group, -1)


def last_share(values, lower, upper):
    """Share of the last group with its interval."""
    return values[-1], lower[-1], upper[-1]


def share(layer, condition):
    """Share of the region's particles that fulfil a condition, with its interval."""
    return last_share(*layer.share_interval(numpy.asarray(condition).astype(int), 2))


def node_share(layer, condition):
    """Share of the grid nodes that fulfil a condition, with its interval."""
    return float(condition.mean()), *layer.interval(condition, numpy.mean)


def coordination_share(layer, number):
    """Share of particles with this many contacts; none has more than the report's list tells."""
    values = layer.estimate("clusters", "cn_fraction")
    return tuple(part[number] if number < len(part) else 0.0 for part in values)


def flowed_back(layer):
    """How far behind the blade powder has come back since it stopped [d_p]."""
    info = layer.state.info
    blade = float(info["blade_start"]) + float(info["spread_length"])
    return max((blade - float(info["layer_end"])) / layer.diameter, 0.0)


def scalars(layer):
    """Name -> (value, lower, upper)."""
    metrics, height = layer.metrics, layer.height
    result = {
        "packing_median": layer.estimate("phi_exact", "median"),
        "packing_iqr_over_median": layer.estimate("phi_exact", "iqr_over_median"),
        "packing_largest": (metrics["phi_exact"]["max"], *UNKNOWN),
        "roughness_dp": layer.estimate("height", "Ra"),
        "empty_area": layer.estimate("height", "empty_fraction"),
        "height_0.75_to_1": node_share(layer, (height > 0.75 + 1e-6) & (height <= 1 + 1e-6)),
        "height_above_1": node_share(layer, height > 1 + 1e-6),
        "height_largest_dp": (metrics["height"]["max"], *UNKNOWN),
        "particles": (metrics["clusters"]["n_particles"], *UNKNOWN),
        "region_length_dp": (layer.x_range[1] - layer.x_range[0], *UNKNOWN),
        "flowed_back_dp": (flowed_back(layer), *UNKNOWN),
        "largest_coordination_number": (len(metrics["clusters"]["cn_counts"]) - 1, *UNKNOWN),
        "largest_cluster": (max(map(int, metrics["clusters"]["size_fraction"])), *UNKNOWN),
        "touching_base": layer.estimate("vertical", "fraction_touching_base"),
        "centre_above_1": layer.estimate("vertical", "fraction_above_1dp"),
        "clustered": share(layer, layer.cluster_size > 1),
        "cluster_2_to_3": share(layer, (layer.cluster_size > 1) & (layer.cluster_size < 4)),
        "cluster_above_2": share(layer, layer.cluster_size > 2),
        "cluster_above_8": share(layer, layer.cluster_size > 8),
        "cluster_below_9": share(layer, layer.cluster_size < 9),
        "perpendicular": last_share(*layer.share_interval(perpendicular(layer, []), 2)),
        "perpendicular_doublets": last_share(*layer.share_interval(perpendicular(layer, [2]), 2)),
    }
    for number in range(6):
        result[f"coordination_{number}"] = coordination_share(layer, number)
    return result | pore_scalars(layer)


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
