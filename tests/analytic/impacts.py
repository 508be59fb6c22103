"""Collisions by adaptive integration, in units where mass, stiffness and normal speed are 1.

Overlap x in units of (m v^2/k)^(2/5), time in that length over v; then x'' = -x^1.5 - alpha x^0.25 x' + pull.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

TOLERANCE = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}


def damping(restitution):
    """alpha of the normal dashpot alpha sqrt(m k) d^(1/4), exact for Hertz when the force may become attractive."""
    log = np.log(restitution)
    return -np.sqrt(5) * log / np.sqrt(log**2 + np.pi**2)


def event(function, direction, terminal=True):
    """An event of solve_ivp."""
    function.terminal, function.direction = terminal, direction
    return function


def normal_impact(alpha, pull=0.0, clip=False):
    """Rebound speed (0: captured), duration and largest overlap of a head-on impact at unit speed."""

    def force(x, v):
        x = max(x, 0.0)
        sum_ = x**1.5 + alpha * x**0.25 * v
        return max(sum_, 0.0) if clip else sum_

    leave = event(lambda t, y: y[0] if t > 0 else 1.0, -1)
    turn = event(lambda t, y: y[1], -1, terminal=False)
    run = solve_ivp(lambda t, y: [y[1], pull - force(*y)], (0, 60), [0.0, 1.0], events=[leave, turn], **TOLERANCE)
    overlap = run.y_events[1][0][0]
    if not run.t_events[0].size:
        return 0.0, np.inf, overlap
    return -run.y_events[0][0][1], run.t_events[0][0], overlap


@dataclass
class Friction:
    """Mindlin-Deresiewicz spring with dashpot, in total-displacement form; both limited to mu F."""

    coefficient: float
    poisson: float
    restitution: float
    tangential_damping: bool = True

    @property
    def slip(self):
        """Displacement at which sliding starts, over the overlap."""
        return self.coefficient * (2 - self.poisson) / (2 - 2 * self.poisson)

    def force(self, x, y, v, sliding):
        """Resistance along the displacement y with sliding velocity v."""
        limit = self.coefficient * x**1.5
        if sliding:
            return np.sign(y) * limit
        share = min(abs(y) / (self.slip * x), 1.0) if x > 0 else 1.0
        # Mindlin: the tangential stiffness is 2 (1-nu)/(2-nu) times the normal one, 3/2 k sqrt(d).
        stiffness = 3 * (1 - self.poisson) / (2 - self.poisson) * np.sqrt(x)
        ratio = damping(self.restitution) / np.sqrt(5) if self.tangential_damping else 0.0
        dashpot = 2 * np.sqrt(5 / 6) * ratio * np.sqrt(stiffness)
        return np.clip(np.sign(y) * limit * (1 - (1 - share) ** 1.5) + dashpot * v, -limit, limit)


def frictional_impact(friction, motion, start, first_time=1e-7):
    """Integrates stick and slip phases until the overlap is used up.

    The state starts with overlap x, its rate, tangential displacement y; motion(state, f) returns the rates of all but
    y, and the sliding velocity, for a friction force function f(sliding velocity). Returns the final state and time.
    """

    def sliding_velocity(state):
        return motion(state, lambda v: 0.0)[1]

    def rates(state, mode):
        x = max(state[0], 0.0)
        others, v = motion(state, lambda velocity: friction.force(x, state[2], velocity, mode != 0))
        drift = mode * friction.slip * state[1] if mode else v
        return np.concatenate([others[:2], [drift], others[2:]])

    state, time = np.array(start, dtype=float), first_time
    v = sliding_velocity(state)
    state[0] = state[1] * first_time
    state[2] = np.sign(v) * min(abs(v) * first_time, friction.slip * state[0])
    mode = int(np.sign(v)) if abs(v) >= friction.slip * state[1] else 0
    leave = event(lambda t, y: y[0], -1)
    while True:
        if mode:
            change = event(lambda t, y, m=mode: m * sliding_velocity(y) - friction.slip * y[1], -1)
        else:
            change = event(lambda t, y: abs(y[2]) - friction.slip * y[0], 1)
        run = solve_ivp(lambda t, y, m=mode: rates(y, m), (time, 60), state, events=[leave, change], **TOLERANCE)
        state, time = run.y[:, -1], run.t[-1]
        if run.t_events[0].size or time >= 60:
            return state, time
        mode = 0 if mode else int(np.sign(state[2]))


def wall_impact(friction, tangential, spin=0.0):
    """Sphere on a wall at unit normal speed, arm = radius. Returns tangential velocity and spin R w afterwards."""
    alpha = damping(friction.restitution)

    def motion(state, force):
        x, rate, _, velocity, spin_ = state
        sliding = velocity + spin_
        f = force(sliding)
        push = x if x > 0 else 0.0
        return np.array([rate, -(push**1.5) - alpha * push**0.25 * rate, -f, -2.5 * f]), sliding

    state, _ = frictional_impact(friction, motion, [0.0, 1.0, 0.0, tangential, spin])
    return state[3], state[4]


def pair_impact(friction, offset, diameter):
    """Two equal spheres of unit relative speed along x that first touch at `offset` = sin(angle of the normal).

    Polar coordinates (distance, angle) of the second relative to the first, contact point at half the distance.
    Returns the relative velocity (x, y) of the second, the spin times the diameter, and the duration, in units of the
    relative speed along the normal at first touch. `diameter` likewise, in units of (m* v^2/k)^(2/5).
    """
    cosine = np.sqrt(1 - offset**2)
    alpha = damping(friction.restitution)

    def motion(state, force):
        x, rate, _, angle_rate, spin, _ = state
        distance = diameter - x
        sliding = distance * (spin - angle_rate) / diameter
        f = force(sliding)
        push = x if x > 0 else 0.0
        swing = angle_rate / diameter
        repulsion = push**1.5 + alpha * push**0.25 * rate
        # m* = m/2 and I = m diameter^2/10 of one sphere; angle_rate and spin carry a factor diameter.
        turn = diameter * (f + 2 * rate * swing) / distance
        spin_up = -2.5 * f * distance / diameter
        return np.array([rate, -repulsion - distance * swing**2, turn, spin_up, swing]), sliding

    tangential = offset / cosine
    start = [0.0, 1.0, 0.0, tangential, 0.0, np.arcsin(offset)]
    state, time = frictional_impact(friction, motion, start)
    _, rate, _, angle_rate, spin, angle = state
    normal, tangent = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    velocity = -rate * normal + angle_rate * tangent
    return velocity, spin, time
