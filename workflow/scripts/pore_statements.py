"""What the paper states about pores (section 5.4). No number here is adjusted to our results.

Where it speaks of the slope of a cumulative distribution, the interquartile range of the sizes stands for it: the
steeper the slope, the narrower the range.
"""

import math

from pore_metrics import FEWEST, GROUPS
from comparisons import varies_more
from extremes import extreme, largest_foreseen_at
from measured import written
from verdicts import FALL, RISE, UNKNOWN, Judgement, all_of, between, decided, difference, missing, only, trend, within


def below(highest):
    """The grid's Bond numbers below one."""
    return lambda grid: [bond for bond in grid.bonds() if bond < highest]


def dominant(name, bond, group, groups):
    """One group of sizes has a larger share of the pores than each of the others."""

    def evaluate(grid):
        shares = {k: grid.measured(f"{name}_group_{k}", bond) for k in groups}
        if shares[group] is None:
            return missing([bond])
        text = "; ".join(f"{GROUPS[k]} d_p: {written(share)}" for k, share in shares.items())
        others = [share for k, share in shares.items() if k != group]
        mine = shares[group]
        if any(math.isnan(share.value) for share in shares.values()):
            return Judgement(f"Bo {bond:g}: fewer than {FEWEST} pores", UNKNOWN, math.inf, (bond,))
        parts = [difference(share, shares[group]) for k, share in shares.items() if k != group]
        return Judgement(f"Bo {bond:g}: {text}", *all_of(parts), (bond,))

    return evaluate


def alike(name, bonds, tolerance):
    """The metric differs by no more than this between the Bond numbers."""

    def evaluate(grid):
        values = {bond: grid.measured(name, bond) for bond in bonds(grid)}
        values = {bond: value for bond, value in values.items() if math.isfinite(value.value)}
        if len(values) < 2:
            return Judgement("fewer than two such cases", UNKNOWN)
        text = "; ".join(f"Bo {bond:g}: {written(value)}" for bond, value in values.items())
        low, high = (choose(values.values(), key=lambda measured: measured.value) for choose in (min, max))
        outward, inward = math.hypot(low.below(), high.above()), math.hypot(low.above(), high.below())
        room = tolerance - (high.value - low.value)
        return Judgement(text, *decided(room, outward if room > 0 else inward), tuple(values))

    return evaluate


PORE_STATEMENTS = [
    (
        "14",
        "Bo < 1: density pores of random orientation (share of their area at 45° or more read as 35 to 65 %)",
        within("pore_perpendicular", below(1), 0.35, 0.65),
    ),
    ("14", "Density pores more across x at Bo 200 than at 0", trend("pore_perpendicular", [0, 200], [RISE])),
    ("14", "Density pores more elongated at Bo 200 than at 0", trend("pore_elongation", [0, 200], [RISE], 1, "")),
    (
        "14",
        "Mean size of density pores: falls to Bo = 50, rises to 400",
        trend("pore_mean_dp", [0, 50, 400], [FALL, RISE], 1, " d_p"),
    ),
    (
        "14",
        "Number of density pores: rises to Bo = 50, falls to 400",
        trend("pore_count", [0, 50, 400], [RISE, FALL], 1, ""),
    ),
    (
        "14",
        "Bo = 400: one density pore covers most of the layer (more than 50 % of the area)",
        within("pore_largest_area", only(400), lower=0.5),
    ),
    (
        "14",
        "Mean size of chamber pores: falls to Bo = 50, rises to 400",
        trend("chamber_mean_dp", [0, 50, 400], [FALL, RISE], 1, " d_p"),
    ),
    (
        "14",
        "Bo > 0: chamber pores strewn evenly along x (share in the second half of the layer read as 40 to 60 %)",
        within("chamber_second_half", between(0, above=True), 0.4, 0.6),
    ),
    (
        "14",
        "Chamber sizes vary more at Bo = 0 than at Bo = 50 (interquartile range)",
        trend("chamber_iqr_dp", [0, 50], [FALL], 1, " d_p"),
    ),
    (
        "15a",
        "Bo = 0: largest density pore 24 d_p (one layer of 390 by 40 d_p)",
        extreme("pore_largest_dp", 0, 24, " d_p"),
    ),
    (
        "15a",
        "Largest density pore of a layer of 390 by 40 d_p: larger at Bo = 0 than from Bo 0.2 to 200",
        largest_foreseen_at("pore_largest_dp", 0, between(0, 200), " d_p"),
    ),
    (
        "15a",
        "Slope of the distribution of density pores larger at Bo 1 than at 0 (interquartile range smaller)",
        trend("pore_iqr_dp", [0, 1], [FALL], 1, " d_p"),
    ),
    (
        "15a",
        "Slope of the distribution of density pores largest at Bo = 50 (interquartile range smallest)",
        trend("pore_iqr_dp", [5, 50, 200], [FALL, RISE], 1, " d_p"),
    ),
    ("15a", "Mean size of density pores: less at Bo 1 than at 0", trend("pore_mean_dp", [0, 1], [FALL], 1, " d_p")),
    (
        "15b",
        "Slope of the distribution of chamber pores largest at Bo = 50 (interquartile range smallest)",
        trend("chamber_iqr_dp", [5, 50, 200], [FALL, RISE], 1, " d_p"),
    ),
    (
        "15b",
        "Bo < 200: most chamber pores smaller than 4 d_p (read as more than 90 %)",
        within("chamber_below_4", below(200), lower=0.9),
    ),
    (
        "15b",
        "Bo < 200: distributions of chamber pores alike up to 1 d_p (shares read as within 10 %; from 0.5 d_p here)",
        alike("chamber_below_1", below(200), 0.10),
    ),
    (
        "16a",
        "Share of density pores of 5 d_p and more: less at Bo 1 than at 0",
        trend("pore_group_5", [0, 1], [FALL]),
    ),
    (
        "16a",
        "Bo = 5: among density pores below 5 d_p, those of 2 to 3 d_p dominate",
        dominant("pore", 5, 2, range(5)),
    ),
    ("16a", "Bo = 50: density pores of 1 to 2 d_p dominate", dominant("pore", 50, 1, range(6))),
    (
        "16a",
        "Bo = 100: among density pores below 5 d_p, those of 2 to 3 d_p dominate",
        dominant("pore", 100, 2, range(5)),
    ),
    (
        "16a",
        "Bo ≥ 200: density pores of 5 d_p and more dominate (more than 50 %)",
        within("pore_group_5", between(200), lower=0.5),
    ),
    (
        "16b",
        "Share of chamber pores of 3 d_p and more: falls to Bo = 50, rises to 400",
        trend("chamber_above_3", [0, 50, 400], [FALL, RISE]),
    ),
    (
        "16b",
        "Up to Bo = 50: share of chamber pores below 1 d_p stable (read as within 10 %)",
        alike("chamber_below_1", lambda grid: grid.bonds(0, 50), 0.10),
    ),
    (
        "16b",
        "Share of chamber pores below 2 d_p: falls sharply beyond Bo = 50",
        trend("chamber_below_2", [50, 200, 400], [FALL, FALL]),
    ),
    (
        "16b",
        "Share of chamber pores of 2 to 3 d_p varies more with cohesion than that below 1 d_p",
        varies_more("chamber_group_2", "chamber_group_0", between(0)),
    ),
]
