"""What the paper states about layers and beds. No number here is adjusted to our results."""

import math

from cluster_statements import CLUSTER_STATEMENTS
from measured import Grid
from mechanism_statements import MECHANISM_STATEMENTS
from packing_statements import PACKING_STATEMENTS
from pore_statements import PORE_STATEMENTS
from surface_statements import SURFACE_STATEMENTS
from verdicts import FAILS, FALL, HOLDS, UNKNOWN, Judgement, all_of, decided, missing, trend

LAYER_STATEMENTS = [
    *PACKING_STATEMENTS,
    *CLUSTER_STATEMENTS,
    *SURFACE_STATEMENTS,
    *PORE_STATEMENTS,
    *MECHANISM_STATEMENTS,
]


def alike_at_all_ratios(rows, name, bound, what):
    """The values of a metric at several stiffness ratios differ from that of the stiffest by no more than a share."""
    by_ratio = Grid(rows.assign(bond_number=rows["stiffness_ratio"]))
    ratios = by_ratio.bonds()
    if len(ratios) < 2:
        return Judgement(f"no {what} at several stiffness ratios", UNKNOWN)
    *others, reference = (by_ratio.measured(name, ratio) for ratio in ratios)
    if not reference.value > 0:
        return Judgement(f"ratio {ratios[-1]:g}: {reference.value:.3g}", UNKNOWN, math.inf)
    parts, found = [], []
    for ratio, value in zip(ratios, others):
        share = value.value / reference.value - 1
        sides = (value.below(), reference.above()) if share < 0 else (value.above(), reference.below())
        uncertainty = math.hypot(*sides) / reference.value
        parts.append(decided(bound - abs(share), uncertainty))
        found.append(f"ratio {ratio:g}: {100 * share:+.2g} ± {100 * uncertainty:.2g} %")
    return Judgement(f"{'; '.join(found)} of ratio {ratios[-1]:g}", *all_of(parts), tuple(set(rows["bond"])))


def bed_independence(beds, bond):
    """Global packing densities at all stiffness ratios within 0.2 % of the stiffest one [paper, figure 2]."""
    rows = beds[beds["bond_number"] == bond].assign(bond=bond)
    return alike_at_all_ratios(rows, "packing_density", 0.002, f"beds of Bo = {bond:g}")


INERTIAL_LENGTHS = {0.0: 8.49, 1.0: 4.24, 5.0: 1.41, 50.0: 0.16, 200.0: 0.04}  # printed with two decimals, cut off


def inertial_lengths(derived):
    """The printed inertial lengths [paper, section 5.5] beside those of the scenes; derived: Bond number -> I_mu."""
    rows = []
    for bond, printed in INERTIAL_LENGTHS.items():
        statement = f"Bo = {bond:g}: inertial length {printed:g} d_p (cut off after two decimals)"
        if bond not in derived:
            rows.append(("section 5.5", statement, missing([bond])))
        else:
            same = math.floor(100 * derived[bond] + 1e-9) == round(100 * printed)
            rows.append(("section 5.5", statement, Judgement(f"{derived[bond]:.4g} d_p", HOLDS if same else FAILS)))
    return rows


def evaluate(metrics, beds, reference_ratio, derived, energy):
    """Rows of the comparison: figure, what the paper says, the judgement."""
    metrics = with_losses(metrics, energy)
    grid = Grid(metrics[metrics["stiffness_ratio"] == reference_ratio])
    packed = Grid(beds[beds["stiffness_ratio"] == reference_ratio])
    rows = [
        (
            "2",
            f"Bo = {bond:g}: global packing density within 0.2 % at every stiffness ratio",
            bed_independence(beds, bond),
        )
        for bond in (5, 50)
    ]
    looser = trend("packing_density", [5, 50], [FALL], 1, "")
    rows.append(("2", "Packed bed looser at Bo = 50 than at Bo = 5", looser(packed)))
    rows += ratio_statements(metrics)
    rows += [(figure, statement, condition(grid)) for figure, statement, condition in LAYER_STATEMENTS]
    return rows + inertial_lengths(derived)


RATIO_BOUNDS = [  # Bond number, metric, bound of the relative difference, what the paper calls it
    (5, "packing_median", 0.036, "medians"),
    (50, "packing_median", 0.053, "medians"),
    (5, "packing_iqr", 0.045, "interquartile ranges"),
    (50, "packing_iqr", 0.137, "interquartile ranges"),
]


def with_losses(metrics, energy):
    """The table of metrics with the losses of energy: those of a whole run, so that only replicates give intervals."""
    case = ["bond_number", "stiffness_ratio", "seed"]
    losses = [name for name in energy.columns if name.startswith("loss_")]
    joined = metrics.merge(energy[case + losses], on=case, how="left")
    return joined.assign(**{f"{name}_{side}": math.nan for name in losses for side in ("lower", "upper")})


def ratio_statements(metrics):
    """The distribution of the local packing density at all stiffness ratios within the paper's bounds [figure 4]."""
    rows = []
    for bond, name, bound, what in RATIO_BOUNDS:
        layers = metrics[metrics["bond_number"] == bond].assign(bond=bond)
        statement = (
            f"Bo = {bond:g}: {what} of the local packing density differ by less than {100 * bound:g} % between ratios"
        )
        rows.append(("4", statement, alike_at_all_ratios(layers, name, bound, f"layers of Bo = {bond:g}")))
    return rows
