"""What the paper states about packing structure (section 5.1). No number here is adjusted to our results."""

from comparisons import falls_with_class, largest_at, less_affected, share_kept
from verdicts import FALL, RISE, between, only, trend, within

PACKING_STATEMENTS = [
    (
        "5",
        "Bo = 0: local packing density reaches 0.3 (read as 0.25 to 0.35)",
        within("packing_largest", only(0), 0.25, 0.35, 1, "", extreme=True),
    ),
    (
        "5",
        "Bo > 0: no variation of the packing density along x (halves of the layer read as within 10 % of the mean)",
        within("packing_drift", between(0, above=True), -0.1, 0.1),
    ),
    ("5", "Share of particles in clusters above 8: less at Bo 5 than at 0", trend("cluster_above_8", [0, 5], [FALL])),
    ("5", "Empty patches (mean chamber pore) smaller at Bo 50 than at 1", trend("chamber_mean_dp", [1, 50], [FALL], 1, " d_p")),
    ("5", "Density more even (IQR / median less) at Bo 50 than at 1", trend("packing_iqr_over_median", [1, 50], [FALL], 1, "")),
    ("5", "Fewer particles deposited at Bo 400 than at 200", trend("particles_per_area", [200, 400], [FALL], 1, " per d_p²")),
    ("5", "Share of particles without contact: largest at Bo = 50", largest_at("coordination_0", 50, between(1))),
    ("5", "Particles have fewer contacts on average at Bo 50 than at 1", trend("cn_mean", [1, 50], [FALL], 1, "")),
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
    ("6", "Bo = 0: the higher the coordination number, the fewer particles (0 to 4)", falls_with_class("coordination", 0, 5)),
    ("6", "Bo = 0: a share of particles with 4 contacts (read as above 1 %)", within("coordination_4", only(0), lower=0.01)),
    ("6a", "Particles without contact: fewer from Bo 0 to 1", trend("coordination_0", [0, 1], [FALL])),
    ("6a", "Particles with one contact: more from Bo 0 to 1", trend("coordination_1", [0, 1], [RISE])),
    (
        "6a",
        "From Bo 0 to 1 the share of particles with more than two contacts changes less than that without contact",
        less_affected("coordination_above_2", "coordination_0", [0, 1]),
    ),
    (
        "6b",
        "Particles without contact: more from Bo 1 to 50, fewer to 200, more to 400",
        trend("coordination_0", [1, 50, 200, 400], [RISE, FALL, RISE]),
    ),
    (
        "6b",
        "Particles with one contact: fewer from Bo 1 to 50, more to 200, fewer to 400",
        trend("coordination_1", [1, 50, 200, 400], [FALL, RISE, FALL]),
    ),
    ("6b", "Particles with more than one contact: fewer from Bo 1 to 50", trend("coordination_above_1", [1, 50], [FALL])),
    (
        "7",
        "Every Bo: the centres peak at 0.5 d_p (more than half of the particles touch the base)",
        within("touching_base", between(0), lower=0.5),
    ),
    (
        "7",
        "Bo < 1: more than 99 % of the particles touch the base",
        within("touching_base", lambda grid: [bond for bond in grid.bonds() if bond < 1], lower=0.99),
    ),
    ("7", "Particles above the base: more at Bo 50 than at 1", trend("touching_base", [1, 50], [FALL])),
    (
        "7",
        "Bo > 50: fewer than 5 % of the centres above 1 d_p",
        within("centre_above_1", between(50, above=True), upper=0.05),
    ),
    ("8a", "Median local packing density: less at Bo 200 than at 0", trend("packing_median", [0, 200], [FALL], 1, "")),
    (
        "8a",
        "Median local packing density: falls only slightly up to Bo 200 (read as by less than 20 %)",
        share_kept("packing_median", 0, 200, 0.8),
    ),
    (
        "8a",
        "Median local packing density: falls from Bo 200 to 400",
        trend("packing_median", [200, 400], [FALL], 1, ""),
    ),
    ("8b", "IQR / median: falls from Bo 0 to 1", trend("packing_iqr_over_median", [0, 1], [FALL], 1, "")),
    (
        "8b",
        "IQR / median: local minimum at Bo = 50",
        trend("packing_iqr_over_median", [5, 50, 200], [FALL, RISE], 1, ""),
    ),
    ("8b", "IQR / median: rises from Bo 200 to 400", trend("packing_iqr_over_median", [200, 400], [RISE], 1, "")),
]
