"""What the paper states about mechanisms (section 5.5). No number here is adjusted to our results.

Energy is that lost by all particles while the layer is spread: the paper's figures say nothing of it, its text does.
"""

from comparisons import larger_than
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
]
