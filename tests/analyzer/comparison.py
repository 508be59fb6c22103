"""Compares a JSON report of recoat-analyze with the expected values of a case."""

from chamber_comparison import chamber_differences

# The expected values have nine digits.
RELATIVE = 1e-6
# Round-off that stands for zero among densities, heights and shares, which are of order one. Values in SI units are not.
ROUND_OFF = 1e-12


def differences(expected, actual, path=""):
    """Yields (path, what is wrong) for every expected key that the report lacks or gives another value for."""
    if path.startswith("/chamber_pores/") and path.count("/") == 2:
        yield from chamber_differences(expected, actual, path)
    elif isinstance(expected, dict):
        yield from _in_mapping(expected, actual, path)
    elif isinstance(expected, list):
        yield from _in_list(expected, actual, path)
    elif not _same(expected, actual, path):
        yield path, f"{actual!r} instead of {expected!r}"


def _in_mapping(expected, actual, path):
    if not isinstance(actual, dict):
        yield path, f"{actual!r} instead of a mapping"
        return
    for key, value in expected.items():
        here = f"{path}/{key}"
        if key not in actual:
            yield here, "is missing"
        elif key == "iqr_over_median" and abs(expected["median"]) < ROUND_OFF:
            # The median is 0, which the expected value may show as a quotient by round-off.
            if actual[key] is not None:
                yield here, f"{actual[key]!r} instead of null, as the median is 0"
        else:
            yield from differences(value, actual[key], here)
    for key in actual.keys() - expected.keys():
        yield f"{path}/{key}", "is not expected"


def _in_list(expected, actual, path):
    if not isinstance(actual, list) or len(actual) != len(expected):
        yield path, f"{actual!r} instead of a list of {len(expected)}"
        return
    for index, (wanted, value) in enumerate(zip(expected, actual, strict=True)):
        yield from differences(wanted, value, f"{path}[{index}]")


def _same(expected, actual, path):
    if isinstance(expected, (str, bool)) or expected is None or actual is None:
        return expected == actual and type(expected) is type(actual)
    if isinstance(expected, int):
        return isinstance(actual, int) and actual == expected
    if not isinstance(actual, (int, float)):
        return False
    in_si = path.endswith(("_m2", "_m3")) or path.startswith("/config/")
    return abs(actual - expected) <= RELATIVE * abs(expected) + (0 if in_si else ROUND_OFF)
