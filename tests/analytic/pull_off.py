"""A sphere torn off by a load that grows evenly, by adaptive integration at the original stiffness."""

import numpy as np
from scipy.integrate import solve_ivp

from friction import event


def pull_off_load(acceleration, stiffness_per_mass, near, far, damping, ramp, gone):
    """Load over the attraction at contact when the separation passes `gone`.

    The attraction over the mass that moves is `acceleration` at contact, as 1/s^2 beyond `near`, nothing beyond `far`;
    the load over that mass grows as 2 acceleration t/ramp. Hertz with `stiffness_per_mass`, dashpot coefficient
    `damping` as alpha in impacts.py. Lengths in units of `near`, times in sqrt(near/acceleration).
    """
    length, clock = near, np.sqrt(near / acceleration)
    k = stiffness_per_mass * np.sqrt(length) * clock**2
    rate = 2 * clock / ramp

    def slopes(t, state):
        s, v = state
        overlap = max(-s, 0.0)
        attraction = 0.0 if s > far / near else 1 / max(s, 1.0) ** 2
        contact = k * overlap**1.5 - damping * np.sqrt(k) * overlap**0.25 * v
        return [v, rate * t - attraction + (contact if s < 0 else 0.0)]

    leave = event(lambda t, y: y[0] - gone / near, 1)
    # At rest under half the load: before that nothing but the overlap changes.
    first = 0.9 / rate
    start = [-((1 - 0.9) / k) ** (2 / 3), 0.0]
    run = solve_ivp(slopes, (first, 2 / rate), start, events=[leave], method="DOP853", rtol=1e-9, atol=1e-12)
    return rate * run.t_events[0][0]
