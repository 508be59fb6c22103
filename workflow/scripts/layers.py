"""Analysed layers and packed beds as the figures use them."""

from dataclasses import dataclass
from functools import cached_property

import numpy

from reporting import read_json
from resampling import counts_by_cell, interval, scattered_interval, shares
from states import read_state


@dataclass
class Layer:
    """One case: what it is, the analyser's metrics, and the state they were computed from."""

    bond: float
    ratio: float
    seed: int
    metrics_path: str
    state_path: str
    bootstrap: dict

    @cached_property
    def metrics(self):
        return read_json(self.metrics_path)

    @cached_property
    def state(self):
        return read_state(self.state_path)

    @property
    def diameter(self):
        """d_p [m]."""
        return self.metrics["config"]["d_p"]

    @property
    def x_range(self):
        """The analysed part along x [d_p]."""
        return [x / self.diameter for x in self.metrics["config"]["x_range"]]

    @property
    def width(self):
        """Period in y [d_p]."""
        return self.metrics["config"]["y_period"] / self.diameter

    @property
    def cells(self):
        """Number of cells of the report's grid along x; of d_p where the report does not say."""
        grid = self.metrics.get("grid")
        return grid["cells"][0] if grid else round(self.x_range[1] - self.x_range[0])

    @property
    def cell(self):
        """Side of these cells [d_p]."""
        return (self.x_range[1] - self.x_range[0]) / self.cells

    @cached_property
    def packing(self):
        """Local packing density at the nodes, [along x, along y]."""
        return numpy.array(self.metrics["maps"]["phi_exact"], dtype=float)

    @cached_property
    def height(self):
        """Surface height at the nodes [d_p], [along x, along y]."""
        return numpy.array(self.metrics["maps"]["height"], dtype=float)

    @cached_property
    def coordination(self):
        """Number of contacts with particles, of every particle of the file."""
        return numpy.array(self.metrics["particles"]["cn"], dtype=int)

    @cached_property
    def cluster_size(self):
        """Members of the cluster of every particle of the file."""
        return numpy.array(self.metrics["particles"]["cluster_size"], dtype=int)

    @cached_property
    def cluster_angle(self):
        """Angle of the cluster of every particle to the spreading direction [degrees]; not a number where none."""
        return numpy.array(self.metrics["particles"]["cluster_angle"], dtype=float)

    def estimate(self, group, name):
        """A quantity of the report with its 95 % interval: value, lower, upper; arrays for a list."""
        found = self.metrics["uncertainty"]
        for part in [*group.split("/"), name]:
            found = found[part]
        values = [numpy.array(found[key], dtype=float) for key in ("value", "lower", "upper")]
        return tuple(value if value.ndim else float(value) for value in values)

    @property
    def resampling(self):
        """The report's own blocks, resamples and seed."""
        made = self.metrics["uncertainty"]
        return {"block": made["block_columns"], "resamples": made["resamples"], "seed": made["seed"]}

    @cached_property
    def density_pores(self):
        """Density pores of the report, by 8 neighbours, from large to small."""
        return self.metrics["density_pores"]["8"]["pores"]

    @cached_property
    def chambers(self):
        """Chamber pores by rule A: x, y from the start of the region, diameter [d_p]."""
        return numpy.array(self.metrics["chamber_pores"]["A"]["circles_x_y_d"], dtype=float).reshape(-1, 3)

    def pore_interval(self, x, values, statistic):
        """95 % interval of a statistic of values of pores, resampled with the columns that their middles x lie in."""
        cell = numpy.clip(numpy.floor(numpy.asarray(x, dtype=float) / self.cell + 1e-6), 0, self.cells - 1)
        return scattered_interval(cell, values, statistic, self.cells, **self.resampling)

    def counts(self, group, groups):
        """Particles of each group in each cell along x; see counts_by_cell."""
        position = self.state.points[:, 0] / self.diameter
        return counts_by_cell(position, self.x_range[0], self.cell, self.cells, numpy.asarray(group), groups)

    def interval(self, values, statistic):
        """95 % interval of a statistic of rows along x that the report does not have."""
        return interval(values, statistic, **self.resampling)

    def share_interval(self, group, groups):
        """Shares of groups of particles and their 95 % interval."""
        counts = self.counts(group, groups)
        return shares(counts), *self.interval(counts, shares)


def load_layers(snakemake):
    """The cases of a rule: its params.cases with input.metrics (or layers) and input.states in the same order."""
    paths = getattr(snakemake.input, "metrics", None) or snakemake.input.layers
    return [
        Layer(case["bond"], case["ratio"], case["seed"], str(path), str(state), dict(snakemake.params.bootstrap))
        for case, path, state in zip(snakemake.params.cases, paths, snakemake.input.states, strict=True)
    ]


def by_bond(layers):
    """Layers grouped by Bond number, ascending; each group holds the seeds."""
    bonds = sorted({layer.bond for layer in layers})
    return {bond: [layer for layer in layers if layer.bond == bond] for bond in bonds}


def by_case(layers):
    """Layers grouped by Bond number and stiffness ratio; each group holds the seeds."""
    groups = {}
    for layer in layers:
        groups.setdefault((layer.bond, layer.ratio), []).append(layer)
    return groups


def column_density(packing):
    """Mean over the columns of a packed bed; rows are places along the period."""
    return packing.mean()


def bed_density(bed):
    """Global packing density of a bed [paper, eq. 14] and its 95 % interval from blocks along the period y.

    The walls make x inhomogeneous, so only y is resampled: the interval of the column mean, moved to the value itself.
    """
    value = bed.metrics["totals"]["eq14_clipped"]
    columns = bed.packing.T
    lower, upper = interval(columns, column_density, bed.bootstrap["bed_block_dp"], bed.bootstrap["resamples"])
    return value, value * lower / columns.mean(), value * upper / columns.mean()
