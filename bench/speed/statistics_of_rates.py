"""Medians and spreads of repeated runs."""

from statistics import median


def spread(values):
    """Median, least and largest; None for no values."""
    values = list(values)
    return {"median": median(values), "least": min(values), "largest": max(values), "repeats": len(values)} if values else None


def ratios(ours, theirs):
    """Spread of the ratios, pair by pair in the order of the runs: what drifts on the machine touches both of a pair."""
    return spread(a / b for a, b in zip(ours, theirs))
