"""What the paper states about layers and beds. No number here is adjusted to our results."""

import math

from extremes import extreme
from measured import Grid
from pore_statements import PORE_STATEMENTS
from verdicts import FAILS, HOLDS, UNKNOWN, Judgement, all_of, between, decided, missing, only, trend, within

RISE, FALL = 1, -1

LAYER_STATEMENTS = [
    (
        "5",
        "Bo = 0: local packing density reaches 0.3 (read as 0.25 to 0.35)",
        within("packing_largest", only(0), 0.25, 0.35, 1, "", extreme=True),
    ),
    (
        "6",
        "Coordination number below 5 for every Bo",
        within("largest_coordination_number", between(0), upper=4, scale=1, unit="", extreme=True),
    ),
    (
        "6",
        "Bo = 0: almost 45 % of the particles without contact (read as 40 to 50 %)",
        within("coordination_0", only(0), 0.40, 0.50),
    ),
    ("6a", "Particles without contact: fewer from Bo 0 to 1", trend("coordination_0", [0, 1], [FALL])),
    ("6a", "Particles with one contact: more from Bo 0 to 1", trend("coordination_1", [0, 1], [RISE])),
    (
        "6b",
        "Particles without contact: more from Bo 1 to 50, fewer to 200, more to 400",
        trend("coordination_0", [1, 50, 200, 400], [RISE, FALL, RISE]),
    ),
    (
        "7",
        "Bo < 1: more than 99 % of the particles touch the base",
        within("touching_base", lambda grid: [bond for bond in grid.bonds() if bond < 1], lower=0.99),
    ),
    (
        "7",
        "Bo > 50: fewer than 5 % of the centres above 1 d_p",
        within("centre_above_1", between(50, above=True), upper=0.05),
    ),
    (
        "8a",
        "Median local packing density: falls from Bo 200 to 400",
        trend("packing_median", [200, 400], [FALL], 1, ""),
    ),
    (
        "8b",
        "IQR / median: local minimum at Bo = 50",
        trend("packing_iqr_over_median", [5, 50, 200], [FALL, RISE], 1, ""),
    ),
    ("8b", "IQR / median: rises from Bo 200 to 400", trend("packing_iqr_over_median", [200, 400], [RISE], 1, "")),
    (
        "10",
        "Bo = 0: largest cluster 136 particles (one layer of 390 by 40 d_p)",
        extreme("largest_cluster", 0, 136, " particles"),
    ),
    ("10a", "Share of particles in clusters of 2 and 3: more from Bo 0 to 1", trend("cluster_2_to_3", [0, 1], [RISE])),
    ("10a", "Share of particles in clusters above 8: less from Bo 0 to 1", trend("cluster_above_8", [0, 1], [FALL])),
    (
        "10",
        "1 < Bo ≤ 50: more than 95 % of the particles in clusters of size below 9",
        within("cluster_below_9", between(1, 50, above=True), lower=0.95),
    ),
    ("10b", "Share of clustered particles: more from Bo 50 to 200", trend("clustered", [50, 200], [RISE])),
    (
        "10b",
        "Share of particles in clusters above 2: less from Bo 200 to 400",
        trend("cluster_above_2", [200, 400], [FALL]),
    ),
    (
        "11a",
        "0 < Bo ≤ 1: doublets tend along x (share at 45° or more below 50 %)",
        within("perpendicular_doublets", between(0, 1, above=True), upper=0.5),
    ),
    (
        "11b",
        "50 ≤ Bo ≤ 200: clusters tend across x (share at 45° or more above 50 %)",
        within("perpendicular", between(50, 200), lower=0.5),
    ),
    ("11b", "Orientation more random at Bo 400 than at 200", trend("perpendicular", [200, 400], [FALL])),
    (
        "12",
        "Bo ≤ 1: more than 80 % of the nodes with 0.75 d_p < z ≤ 1 d_p",
        within("height_0.75_to_1", between(0, 1), lower=0.8),
    ),
    ("12", "Empty nodes: fewer from Bo 1 to 50, more to 400", trend("empty_area", [1, 50, 400], [FALL, RISE])),
    (
        "12",
        "Nodes above 1 d_p: more from Bo 5 to 50, fewer to 400",
        trend("height_above_1", [5, 50, 400], [RISE, FALL]),
    ),
    (
        "12",
        "Surface height never above the clearance of 1.5 d_p",
        within("height_largest_dp", between(0), upper=1.5, scale=1, unit=" d_p", extreme=True),
    ),
    ("13", "Bo ≤ 1: roughness falls with Bo, towards 0.12 d_p", trend("roughness_dp", [0, 1], [FALL], 1, " d_p")),
    (
        "13",
        "Bo = 1: roughness about 0.12 d_p (read as 0.10 to 0.14)",
        within("roughness_dp", only(1), 0.10, 0.14, 1, " d_p"),
    ),
    ("13", "Roughness: local minimum at Bo = 50", trend("roughness_dp", [5, 50, 200], [FALL, RISE], 1, " d_p")),
    ("13", "Roughness rises from Bo 200 to 400", trend("roughness_dp", [200, 400], [RISE], 1, " d_p")),
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


def evaluate(metrics, beds, reference_ratio, derived):
    """Rows of the comparison: figure, what the paper says, the judgement."""
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
    rows += [(figure, statement, condition(grid)) for figure, statement, condition in LAYER_STATEMENTS + PORE_STATEMENTS]
    return rows + inertial_lengths(derived)


def ratio_statements(metrics):
    """Medians of the local packing density at all stiffness ratios within the paper's bounds [figure 4]."""
    rows = []
    for bond, bound in ((5, 0.036), (50, 0.053)):
        layers = metrics[metrics["bond_number"] == bond].assign(bond=bond)
        statement = (
            f"Bo = {bond:g}: medians of the local packing density differ by less than {100 * bound:g} % between ratios"
        )
        found = alike_at_all_ratios(layers, "packing_median", bound, f"layers of Bo = {bond:g}")
        rows.append(("4", statement, found))
    return rows
