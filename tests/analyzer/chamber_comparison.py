"""Compares the chamber pores of one rule with the expected ones.

Real data can put comparisons that decide about a circle within 1e-8, so up to two circles may be missing or more. What is
derived from the sizes must follow from the sizes reported; it must be the expected value where the sizes are.
"""

import statistics

TOLERANCE = 1e-6
SPARE = 2
GROUPS = 6


def chamber_differences(expected, actual, path):
    if not isinstance(actual, dict) or actual.keys() != expected.keys():
        yield path, f"{actual!r} instead of the keys {list(expected)}"
        return
    missing, more = unmatched(_rows(expected["sorted_sizes"]), _rows(actual["sorted_sizes"]))
    if max(len(missing), len(more)) > SPARE:
        yield f"{path}/sorted_sizes", f"without {missing}, with {more}"
    if actual["sorted_sizes"] != sorted(actual["sorted_sizes"]):
        yield f"{path}/sorted_sizes", "not sorted"
    wanted = derived(actual["sorted_sizes"]) if missing or more else expected
    for key, value in derived(actual["sorted_sizes"]).items():
        if not (_close(value, actual[key]) and _close(wanted[key], actual[key])):
            yield f"{path}/{key}", f"{actual[key]!r} instead of {wanted[key]!r}"
    for key in expected.keys() & {"circles_x_y_d", "circles_x_y_d_persistence"}:
        missing, more = unmatched(expected[key], actual[key])
        if len(actual[key]) != actual["count"] or max(len(missing), len(more)) > SPARE:
            yield f"{path}/{key}", f"without {missing}, with {more}"
    if "n_beyond_data" in expected and abs(expected["n_beyond_data"] - actual["n_beyond_data"]) > (SPARE if missing or more else 0):
        yield f"{path}/n_beyond_data", f"{actual['n_beyond_data']!r} instead of {expected['n_beyond_data']!r}"


def derived(sizes):
    """Statistics of sizes, written out anew."""
    groups = [[d for d in sizes if min(int(d + TOLERANCE), GROUPS - 1) == g] for g in range(GROUPS)]
    area = sum(d * d for d in sizes)
    return {
        "count": len(sizes),
        "mean": sum(sizes) / len(sizes) if sizes else 0.0,
        "median": statistics.median(sizes) if sizes else 0.0,
        "max": max(sizes, default=0.0),
        "group_number_fraction": [len(g) / len(sizes) if sizes else 0.0 for g in groups],
        "group_area_fraction": [sum(d * d for d in g) / area if sizes else 0.0 for g in groups],
    }


def unmatched(expected, actual):
    """Rows of each list without a partner in the other, in whatever order they come."""
    left, missing = sorted(actual), []
    for row in expected:
        partner = next((other for other in left if _close(row, other)), None)
        if partner is None:
            missing.append(row)
        else:
            left.remove(partner)
    return missing, left


def _rows(sizes):
    return [[size] for size in sizes]


def _close(a, b):
    if isinstance(a, list):
        return len(a) == len(b) and all(_close(x, y) for x, y in zip(a, b, strict=True))
    return abs(a - b) <= TOLERANCE * max(1.0, abs(a))
