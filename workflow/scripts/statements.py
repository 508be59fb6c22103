"""What the paper states about layers and beds. No number here is adjusted to our results."""

import math

from pore_statements import PORE_STATEMENTS
from verdicts import AGREES, DIFFERS, NOT_TESTABLE, Grid, between, missing, only, trend, within

RISE, FALL = 1, -1

LAYER_STATEMENTS = [
    (
        "5",
        "Bo = 0: local packing density reaches 0.3 (read as 0.25 to 0.35)",
        within("packing_largest", only(0), 0.25, 0.35, 1, ""),
    ),
    (
        "6",
        "Coordination number below 5 for every Bo",
        within("largest_coordination_number", between(0), upper=4, scale=1, unit=""),
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
    ("10", "Bo = 0: largest cluster 136 particles (one layer of 390 by 40 d_p; an extreme value)", None),
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
        within("height_largest_dp", between(0), upper=1.5, scale=1, unit=" d_p"),
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


def largest_cluster(grid):
    """The paper's largest cluster belongs to one layer of a stated size; a smaller layer cannot test it."""
    measured = grid.measured("largest_cluster", 0)
    if measured is None:
        return missing([0])
    particles = grid.measured("particles", 0).value
    return f"{measured.value:g} of {particles:g} particles", NOT_TESTABLE


def bed_independence(beds, bond):
    """Global packing densities at all stiffness ratios within 0.2 % of the stiffest one [paper, figure 2]."""
    rows = Grid(beds[beds["bond_number"] == bond].assign(bond_number=lambda table: table["stiffness_ratio"]))
    ratios = rows.bonds()
    if len(ratios) < 2:
        return f"no beds of Bo = {bond:g} at several stiffness ratios", NOT_TESTABLE
    values = [rows.measured("packing_density", ratio) for ratio in ratios]
    reference = values[-1].value
    difference = max(abs(value.value / reference - 1) for value in values)
    uncertainty = max(0.5 * (value.upper - value.lower) / reference for value in values)
    text = f"largest difference {100 * difference:.2g} % of ratio {ratios[-1]:g}, uncertainty {100 * uncertainty:.2g} %"
    if uncertainty > 0.002:
        return text, NOT_TESTABLE if difference <= 0.002 + 2 * uncertainty else DIFFERS
    return text, AGREES if difference <= 0.002 else DIFFERS


INERTIAL_LENGTHS = {0.0: 8.49, 1.0: 4.24, 5.0: 1.41, 50.0: 0.16, 200.0: 0.04}  # printed with two decimals, cut off


def inertial_lengths(derived):
    """The printed inertial lengths [paper, section 5.5] beside those of the scenes; derived: Bond number -> I_mu."""
    rows = []
    for bond, printed in INERTIAL_LENGTHS.items():
        statement = f"Bo = {bond:g}: inertial length {printed:g} d_p (cut off after two decimals)"
        if bond not in derived:
            rows.append(("section 5.5", statement, *missing([bond])))
        else:
            same = math.floor(100 * derived[bond] + 1e-9) == round(100 * printed)
            rows.append(("section 5.5", statement, f"{derived[bond]:.4g} d_p", AGREES if same else DIFFERS))
    return rows


def evaluate(metrics, beds, reference_ratio, derived):
    """Rows of the comparison: figure, what the paper says, what the grid gives, verdict."""
    grid = Grid(metrics[metrics["stiffness_ratio"] == reference_ratio])
    packed = Grid(beds[beds["stiffness_ratio"] == reference_ratio])
    rows = [
        (
            "2",
            f"Bo = {bond:g}: global packing density within 0.2 % at every stiffness ratio",
            *bed_independence(beds, bond),
        )
        for bond in (5, 50)
    ]
    looser = trend("packing_density", [5, 50], [FALL], 1, "")
    rows.append(("2", "Packed bed looser at Bo = 50 than at Bo = 5", *looser(packed)))
    rows += ratio_statements(metrics)
    for figure, statement, condition in LAYER_STATEMENTS:
        rows.append((figure, statement, *(condition or largest_cluster)(grid)))
    rows += [(figure, statement, *condition(grid)) for figure, statement, condition in PORE_STATEMENTS]
    return rows + inertial_lengths(derived)


def ratio_statements(metrics):
    """Medians of the local packing density at all stiffness ratios within the paper's bounds [figure 4]."""
    rows = []
    for bond, bound in ((5, 0.036), (50, 0.053)):
        layers = Grid(
            metrics[metrics["bond_number"] == bond].assign(bond_number=lambda table: table["stiffness_ratio"])
        )
        statement = (
            f"Bo = {bond:g}: medians of the local packing density differ by less than {100 * bound:g} % between ratios"
        )
        ratios = layers.bonds()
        if len(ratios) < 2:
            rows.append(("4", statement, f"no layers of Bo = {bond:g} at several stiffness ratios", NOT_TESTABLE))
            continue
        values = [layers.measured("packing_median", ratio) for ratio in ratios]
        smallest, largest = min(v.value for v in values), max(v.value for v in values)
        difference = largest / smallest - 1 if smallest > 0 else math.inf
        uncertainty = max(0.5 * (v.upper - v.lower) for v in values) / max(smallest, 1e-12)
        text = f"{100 * difference:.2g} %, uncertainty {100 * uncertainty:.2g} %"
        if difference <= bound:
            rows.append(("4", statement, text, AGREES if uncertainty <= bound else NOT_TESTABLE))
        else:
            rows.append(("4", statement, text, DIFFERS if difference > bound + 2 * uncertainty else NOT_TESTABLE))
    return rows
