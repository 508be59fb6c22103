"""What the paper states about mechanisms and the optimum (sections 5.5 and 6). No number here is adjusted to our results.

Energy is that lost by all particles while the layer is spread: the paper's figures say nothing of it, its text does.
"""

from comparisons import larger_than, lowest_at
from verdicts import between

MECHANISM_STATEMENTS = [
    (
        "section 5.5",
        "Bo ≤ 1: more energy is lost by collisions than by sliding",
        larger_than("loss_collisions", "loss_sliding", between(0, 1)),
    ),
    (
        "section 5.5",
        "Bo > 0: more energy is lost by sliding than by rolling",
        larger_than("loss_sliding", "loss_rolling", between(0, above=True)),
    ),
    *(
        ("section 5.5", f"Between the regimes an optimum around Bo = 50: smallest {what}", lowest_at(name, 50, between(0), 1, unit))
        for name, what, unit in (
            ("packing_iqr_over_median", "IQR / median of the local packing density", ""),
            ("roughness_dp", "roughness", " d_p"),
            ("pore_mean_dp", "mean density pore", " d_p"),
            ("chamber_mean_dp", "mean chamber pore", " d_p"),
        )
    ),
]
