"""Stick and slip of a Mindlin-Deresiewicz contact in the course of an impact, by adaptive integration.

Units as in impacts.py: mass, normal stiffness and normal speed are 1.
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

    @property
    def ratio(self):
        """beta of the restitution."""
        return damping(self.restitution) / np.sqrt(5)

    def limit(self, x):
        """Resistance while it slides."""
        return self.coefficient * max(x, 0.0) ** 1.5

    def stick(self, x, y, v):
        """Resistance along the displacement y with sliding velocity v."""
        x, limit = max(x, 0.0), self.limit(x)
        share = min(abs(y) / (self.slip * x), 1.0) if x > 0 else 1.0
        # Mindlin: the tangential stiffness is 2 (1-nu)/(2-nu) times the normal one, 3/2 k sqrt(d).
        stiffness = 3 * (1 - self.poisson) / (2 - self.poisson) * np.sqrt(x)
        ratio = self.ratio if self.tangential_damping else 0.0
        dashpot = 2 * np.sqrt(5 / 6) * ratio * np.sqrt(stiffness)
        return np.clip(np.sign(y) * limit * (1 - (1 - share) ** 1.5) + dashpot * v, -limit, limit)


class StickSlip:
    """The phases of a contact whose state starts with overlap x, its rate and tangential displacement y.

    motion(state, f) returns the rates of all but y, and the sliding velocity, for the resistance f. Three phases:
    `stick`; `slide`, with y at its limit, which moves with x, under the full resistance; and `held`. In this one y
    stays at the limit because the dashpot, which acts in stick only, would drive it out and the full resistance back
    in: between the two there is one resistance that keeps the sliding velocity that of the limit (the solution of
    Filippov, which steps of finite length approach by chattering).
    """

    def __init__(self, friction, motion):
        self.friction, self.motion = friction, motion

    def sliding(self, state):
        return self.motion(state, 0.0)[1]

    def excess(self, state):
        """Sliding velocity over that of the limit; negative: y leaves its limit."""
        return np.sign(state[2]) * self.sliding(state) - self.friction.slip * state[1]

    def excess_rate(self, state, force):
        others = self.motion(state, force)[0]
        rates, h = np.concatenate([others[:2], [0.0], others[2:]]), 1e-6
        return (self.excess(state + h * rates) - self.excess(state - h * rates)) / (2 * h)

    def stick_force(self, state):
        return self.friction.stick(state[0], state[2], self.sliding(state))

    def slide_force(self, state):
        return np.sign(state[2]) * self.friction.limit(state[0])

    def held_force(self, state):
        free, one = self.excess_rate(state, 0.0), self.excess_rate(state, 1.0)
        return free / (free - one)

    def rates(self, state, phase):
        force = getattr(self, f"{phase}_force")(state)
        others, sliding = self.motion(state, force)
        drift = sliding if phase == "stick" else np.sign(state[2]) * self.friction.slip * state[1]
        return np.concatenate([others[:2], [drift], others[2:]])

    def ends(self, phase):
        """Events that end a phase, with the phase that follows; None: to be decided there."""
        if phase == "stick":
            return [(event(lambda t, y: abs(y[2]) - self.friction.slip * y[0], 1), "slide")]
        if phase == "slide":
            return [(event(lambda t, y: self.excess(y), -1), None)]
        above = event(lambda t, y: np.sign(y[2]) * (self.held_force(y) - self.stick_force(y)), -1)
        below = event(lambda t, y: np.sign(y[2]) * (self.slide_force(y) - self.held_force(y)), -1)
        return [(above, "stick"), (below, "slide")]

    def run(self, start, first_time=1e-7):
        """Integrates until the overlap is used up. Returns the final state and time."""
        state, time = np.array(start, dtype=float), first_time
        slip, v = self.friction.slip, self.sliding(state)
        state[0] = state[1] * first_time
        state[2] = np.sign(v) * min(abs(v) * first_time, slip * state[0])
        phase = "slide" if abs(v) >= slip * state[1] else "stick"
        leave = event(lambda t, y: y[0], -1)
        while True:
            ends = self.ends(phase)
            run = solve_ivp(
                lambda t, y, p=phase: self.rates(y, p),
                (time, 60),
                state,
                events=[leave, *(end for end, _ in ends)],
                **TOLERANCE,
            )
            state, time = run.y[:, -1], run.t[-1]
            if run.t_events[0].size or time >= 60:
                return state, time
            phase = next(then for found, (_, then) in zip(run.t_events[1:], ends) if found.size)
            if phase is None:
                phase = "held" if self.excess_rate(state, self.stick_force(state)) > 0 else "stick"
