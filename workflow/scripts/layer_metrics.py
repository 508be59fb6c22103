"""Scalar metrics of one layer, each with the 95 % interval of a block bootstrap along x.

Intervals are those of the report where it has them; the others are made with the same resamples. Those of shares are
never narrower than if particles, nodes or pores were independent: resamples of what was not seen have none of it either.
"""

import numpy

from pore_metrics import pore_scalars
from resampling import no_narrower_than_independent

UNKNOWN = (numpy.nan, numpy.nan)  # extreme values and counts of the whole layer: resampling does not tell their scatter


def as_share(layer, estimate):
    """A share of the region's particles as the report has it, its interval never too narrow for so many particles."""
    return no_narrower_than_independent(*estimate, layer.metrics["clusters"]["n_particles"])


def share_among(layer, among, condition):
    """Share of those particles of the region that fulfil a condition, with its interval."""
    group = numpy.where(among, numpy.asarray(condition).astype(int), -1)
    values, lower, upper = layer.share_interval(group, 2)
    return no_narrower_than_independent(values[1], lower[1], upper[1], layer.counts(group, 2).sum())


def share(layer, condition):
    """Share of the region's particles that fulfil a condition, with its interval."""
    return share_among(layer, True, condition)


def node_share(layer, condition):
    """Share of the grid nodes that fulfil a condition, with its interval."""
    estimate = float(condition.mean()), *layer.interval(condition, numpy.mean)
    return no_narrower_than_independent(*estimate, condition.size)


def coordination_share(layer, number):
    """Share of particles with this many contacts; none has more than the report's list tells."""
    values = layer.estimate("clusters", "cn_fraction")
    return as_share(layer, tuple(part[number] if number < len(part) else 0.0 for part in values))


def drift(layer):
    """Mean packing density of the second half of the layer less that of the first, over that of both."""
    columns = layer.packing.mean(axis=1)
    rows = numpy.column_stack([columns, numpy.arange(len(columns)) >= len(columns) / 2])

    def statistic(chosen):
        later = chosen[:, 1] > 0.5
        if later.all() or not later.any() or not chosen[:, 0].mean() > 0:
            return numpy.nan
        return (chosen[later, 0].mean() - chosen[~later, 0].mean()) / chosen[:, 0].mean()

    return statistic(rows), *layer.interval(rows, statistic)


def particles_per_area(layer):
    """Particles of the region over its area [1 / d_p^2]."""
    rows = layer.counts(numpy.zeros(len(layer.state.points), dtype=int), 1) / (layer.cell * layer.width)
    return rows.mean(), *layer.interval(rows, numpy.mean)


def by_size(layer):
    """Particles of the region in clusters of 0, 1, 2 ... members in each cell along x."""
    largest = max(map(int, layer.metrics["clusters"]["size_fraction"]))
    return layer.counts(layer.cluster_size, largest + 1)


def mean_cluster(rows):
    """Mean size of a particle's cluster, of the particles that have contacts; not a number where none has."""
    members = rows.sum(axis=0)[2:]
    return (members * numpy.arange(2, 2 + len(members))).sum() / members.sum() if members.sum() else numpy.nan


def doublets_among_clusters(rows):
    """Share of doublets in the number of clusters; not a number without clusters."""
    members = rows.sum(axis=0)[2:]
    clusters = members / numpy.arange(2, 2 + len(members))
    return clusters[0] / clusters.sum() if clusters.sum() else numpy.nan


def of_sizes(layer, statistic):
    """A statistic of the sizes of clusters with its interval."""
    rows = by_size(layer)
    return statistic(rows), *layer.interval(rows, statistic)


def flowed_back(layer):
    """How far behind the blade powder has come back since it stopped [d_p]."""
    info = layer.state.info
    blade = float(info["blade_start"]) + float(info["spread_length"])
    return max((blade - float(info["layer_end"])) / layer.diameter, 0.0)


def packing_scalars(layer):
    """Of the packing structure [paper, section 5.1]."""
    metrics = layer.metrics
    result = {
        "packing_median": layer.estimate("phi_exact", "median"),
        "packing_iqr": layer.estimate("phi_exact", "iqr"),
        "packing_iqr_over_median": layer.estimate("phi_exact", "iqr_over_median"),
        "packing_largest": (metrics["phi_exact"]["max"], *UNKNOWN),
        "packing_drift": drift(layer),
        "particles": (metrics["clusters"]["n_particles"], *UNKNOWN),
        "particles_per_area": particles_per_area(layer),
        "region_length_dp": (layer.x_range[1] - layer.x_range[0], *UNKNOWN),
        "flowed_back_dp": (flowed_back(layer), *UNKNOWN),
        "cn_mean": layer.estimate("clusters", "cn_mean"),
        "largest_coordination_number": (len(metrics["clusters"]["cn_counts"]) - 1, *UNKNOWN),
        "touching_base": as_share(layer, layer.estimate("vertical", "fraction_touching_base")),
        "centre_above_1": as_share(layer, layer.estimate("vertical", "fraction_above_1dp")),
        "coordination_above_1": share(layer, layer.coordination > 1),
        "coordination_above_2": share(layer, layer.coordination > 2),
    }
    return result | {f"coordination_{number}": coordination_share(layer, number) for number in range(6)}


def cluster_scalars(layer):
    """Of clusters [paper, section 5.2]."""
    size, angle = layer.cluster_size, layer.cluster_angle
    along = (size > 1) & (angle < 45)
    return {
        "largest_cluster": (max(map(int, layer.metrics["clusters"]["size_fraction"])), *UNKNOWN),
        "cluster_mean": of_sizes(layer, mean_cluster),
        "clustered": share(layer, size > 1),
        "doublets": share(layer, size == 2),
        "cluster_2_to_3": share(layer, (size > 1) & (size < 4)),
        "cluster_above_2": share(layer, size > 2),
        "cluster_above_8": share(layer, size > 8),
        "cluster_below_9": share(layer, size < 9),
        "doublets_of_clusters": of_sizes(layer, doublets_among_clusters),
        "doublets_of_along": share_among(layer, along, size == 2),
        "chain_like": share_among(layer, size > 2, layer.coordination < 3),
        "perpendicular": share_among(layer, (size > 1) & numpy.isfinite(angle), angle >= 45),
        "perpendicular_doublets": share_among(layer, (size == 2) & numpy.isfinite(angle), angle >= 45),
        "perpendicular_medium": share_among(layer, (size > 2) & (size < 5) & numpy.isfinite(angle), angle >= 45),
        "perpendicular_large": share_among(layer, (size > 4) & numpy.isfinite(angle), angle >= 45),
    }


def surface_scalars(layer):
    """Of the surface [paper, section 5.3]."""
    height = layer.height
    return {
        "roughness_dp": layer.estimate("height", "Ra"),
        "empty_area": layer.estimate("height", "empty_fraction"),
        "height_0.75_to_1": node_share(layer, (height > 0.75 + 1e-6) & (height <= 1 + 1e-6)),
        "height_above_1": node_share(layer, height > 1 + 1e-6),
        "height_largest_dp": (layer.metrics["height"]["max"], *UNKNOWN),
    }


def scalars(layer):
    """Name -> (value, lower, upper)."""
    return packing_scalars(layer) | cluster_scalars(layer) | surface_scalars(layer) | pore_scalars(layer)
