"""What the paper states about the surface of layers (section 5.3). No number here is adjusted to our results."""

from comparisons import linear, slowing
from verdicts import FALL, RISE, between, only, trend, within

SURFACE_STATEMENTS = [
    (
        "12",
        "Bo ≤ 1: more than 80 % of the nodes with 0.75 d_p < z ≤ 1 d_p",
        within("height_0.75_to_1", between(0, 1), lower=0.8),
    ),
    ("12", "Several layers from Bo = 5 on: more nodes above 1 d_p than at Bo = 1", trend("height_above_1", [1, 5], [RISE])),
    ("12", "Empty nodes: fewer from Bo 0 to 1 to 50", trend("empty_area", [0, 1, 50], [FALL, FALL])),
    ("12", "Empty nodes: fewer from Bo 1 to 50, more to 400", trend("empty_area", [1, 50, 400], [FALL, RISE])),
    (
        "12",
        "Bo = 50: some nodes above 1.25 d_p",
        within("height_largest_dp", only(50), lower=1.25, scale=1, unit=" d_p", extreme=True),
    ),
    (
        "12",
        "Surface height never above the clearance of 1.5 d_p",
        within("height_largest_dp", between(0), upper=1.5, scale=1, unit=" d_p", extreme=True),
    ),
    (
        "12",
        "Nodes with 0.75 d_p < z ≤ 1 d_p: fewer from Bo 1 to 50 to 400",
        trend("height_0.75_to_1", [1, 50, 400], [FALL, FALL]),
    ),
    (
        "12",
        "Nodes above 1 d_p: more from Bo 5 to 50, fewer to 400",
        trend("height_above_1", [5, 50, 400], [RISE, FALL]),
    ),
    ("13", "Bo ≤ 1: roughness falls with Bo, towards 0.12 d_p", trend("roughness_dp", [0, 1], [FALL], 1, " d_p")),
    (
        "13",
        "Bo = 1: roughness about 0.12 d_p (read as 0.10 to 0.14)",
        within("roughness_dp", only(1), 0.10, 0.14, 1, " d_p"),
    ),
    ("13", "Roughness: local minimum at Bo = 50", trend("roughness_dp", [5, 50, 200], [FALL, RISE], 1, " d_p")),
    (
        "13",
        "Roughness rises more slowly from Bo 100 to 200 than from 50 to 100",
        slowing("roughness_dp", [50, 100, 200], " d_p"),
    ),
    ("13", "Roughness rises from Bo 200 to 400", trend("roughness_dp", [200, 400], [RISE], 1, " d_p")),
    (
        "13",
        "Roughness rises almost linearly from Bo 200 to 400 (read as within 10 % of the rise)",
        linear("roughness_dp", 200, 400, 0.1, " d_p"),
    ),
]
