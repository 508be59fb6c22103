"""Numbers as a person reads them: a unit with the prefix that fits, durations in hours and minutes."""

import math

PREFIXES = {-9: "n", -6: "u", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}
ROOT_OF_MASS = "kg"  # takes prefixes as gram


def quantity(value, unit, digits=4):
    """50 um for 5e-5 and m; a unit that is not a plain symbol gets no prefix."""
    if value is None or not math.isfinite(value):
        return "infinite" if value is None or math.isinf(value) else "undefined"
    if unit == ROOT_OF_MASS:
        return quantity(1e3 * value, "g", digits)
    if not unit.replace("/", "").isalpha() and unit or value == 0:
        return f"{value:.{digits}g} {unit}".rstrip()
    power = 3 * math.floor(math.log10(abs(value) * (1 + 0.5 * 10**-digits)) / 3)
    if power not in PREFIXES:
        return f"{value:.{digits}g} {unit}"
    return f"{value / 10.0**power:.{digits}g} {PREFIXES[power]}{unit}"


def duration(seconds):
    """3.2 s, 4 min 10 s, 2 h 5 min, 3 d 4 h."""
    if seconds < 60:
        return f"{seconds:.3g} s"
    for size, name, below, below_name in ((86400, "d", 3600, "h"), (3600, "h", 60, "min"), (60, "min", 1, "s")):
        if round(seconds / below) * below >= size:
            whole, rest = divmod(round(seconds / below) * below, size)
            return f"{whole} {name}" + (f" {rest // below} {below_name}" if rest else "")
    return f"{seconds:.3g} s"
