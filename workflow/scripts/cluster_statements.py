"""What the paper states about particle clusters (section 5.2). No number here is adjusted to our results.

Directions are judged by the share of particles whose cluster lies at 45 degrees or more to the spreading direction: one
half where there is no preference. A chain has no particle with more than two contacts.
"""

from comparisons import jointly
from extremes import extreme
from verdicts import FALL, RISE, between, only, trend, within

WEAK = between(0, 1, above=True)
NO_PREFERENCE = (0.4, 0.6)

CLUSTER_STATEMENTS = [
    ("9", "Mean size of a particle's cluster: less at Bo 5 than at 0", trend("cluster_mean", [0, 5], [FALL], 1, "")),
    ("9", "Mean size of a particle's cluster: more at Bo 200 than at 5", trend("cluster_mean", [5, 200], [RISE], 1, "")),
    (
        "9",
        "Shape of clusters shifts from agglomerates to chains: share without triple contact larger at Bo 50 than at 0",
        trend("chain_like", [0, 50], [RISE]),
    ),
    (
        "9",
        "Bo > 5: chains dominate (more than half of the particles in clusters above 2)",
        within("chain_like", between(5, above=True), lower=0.5),
    ),
    (
        "9",
        "Bo > 5: most clusters are doublets (more than half of them)",
        within("doublets_of_clusters", between(5, above=True), lower=0.5),
    ),
    (
        "9",
        "5 ≤ Bo ≤ 200: clusters tend across x (share at 45° or more above 50 %)",
        within("perpendicular", between(5, 200), lower=0.5),
    ),
    ("9", "Clusters lie more across x at Bo 50 than at 1", trend("perpendicular", [1, 50], [RISE])),
    (
        "10",
        "Every Bo: most clusters are doublets (more than half of them)",
        within("doublets_of_clusters", between(0), lower=0.5),
    ),
    (
        "10",
        "Bo = 0: largest cluster 136 particles (one layer of 390 by 40 d_p)",
        extreme("largest_cluster", 0, 136, " particles"),
    ),
    ("10a", "Share of particles in clusters of 2 and 3: more from Bo 0 to 1", trend("cluster_2_to_3", [0, 1], [RISE])),
    ("10a", "Share of particles in clusters above 8: less from Bo 0 to 1", trend("cluster_above_8", [0, 1], [FALL])),
    ("10b", "Share of clustered particles: less at Bo 50 than at 1", trend("clustered", [1, 50], [FALL])),
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
        "Bo = 0: small, medium and large clusters without preference (share at 45° or more read as 40 to 60 %)",
        jointly(
            within("perpendicular_doublets", only(0), *NO_PREFERENCE),
            within("perpendicular_medium", only(0), *NO_PREFERENCE),
            within("perpendicular_large", only(0), *NO_PREFERENCE),
        ),
    ),
    (
        "11a",
        "0 < Bo ≤ 1: doublets tend along x (share at 45° or more below 50 %)",
        within("perpendicular_doublets", WEAK, upper=0.5),
    ),
    (
        "11a",
        "0 < Bo ≤ 1: medium and large clusters without preference (share at 45° or more read as 40 to 60 %)",
        jointly(
            within("perpendicular_medium", WEAK, *NO_PREFERENCE),
            within("perpendicular_large", WEAK, *NO_PREFERENCE),
        ),
    ),
    ("11a", "Share of particles in doublets: more from Bo 0 to 1", trend("doublets", [0, 1], [RISE])),
    (
        "11b",
        "50 ≤ Bo ≤ 200: clusters tend across x (share at 45° or more above 50 %)",
        within("perpendicular", between(50, 200), lower=0.5),
    ),
    ("11b", "Clusters lie more across x at Bo 50 than at 5", trend("perpendicular", [5, 50], [RISE])),
    ("11b", "Orientation more random at Bo 400 than at 200", trend("perpendicular", [200, 400], [FALL])),
    (
        "11b",
        "Bo = 400: clusters in other directions than across are mostly doublets (more than half of the particles below 45°)",
        within("doublets_of_along", only(400), lower=0.5),
    ),
]
