"""Collisions by adaptive integration, in units where mass, stiffness and normal speed are 1.

Overlap x in units of (m v^2/k)^(2/5), time in that length over v; then x'' = -x^1.5 - alpha x^0.25 x' + pull.
"""

import numpy as np
from scipy.integrate import solve_ivp

from friction import TOLERANCE, StickSlip, damping, event


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


def wall_impact(friction, tangential, spin=0.0):
    """Sphere on a wall at unit normal speed, arm = radius. Returns tangential velocity and spin R w afterwards."""
    alpha = damping(friction.restitution)

    def motion(state, f):
        x, rate, _, velocity, spin_ = state
        push = x if x > 0 else 0.0
        return np.array([rate, -(push**1.5) - alpha * push**0.25 * rate, -f, -2.5 * f]), velocity + spin_

    state, _ = StickSlip(friction, motion).run([0.0, 1.0, 0.0, tangential, spin])
    return state[3], state[4]


def pair_impact(friction, offset, diameter, radius_arm=False):
    """Two equal spheres of unit relative speed along x that first touch at `offset` = sin(angle of the normal).

    Polar coordinates (distance, angle) of the second relative to the first; the arm of friction is half the distance,
    or the radius. Returns the relative velocity (x, y) of the second, the spin times the diameter, the duration, and
    the angular momentum over that of the start, in units of the relative speed along the normal at first touch.
    `diameter` likewise, in units of (m* v^2/k)^(2/5).
    """
    cosine = np.sqrt(1 - offset**2)
    alpha = damping(friction.restitution)

    def motion(state, f):
        x, rate, _, angle_rate, spin, _ = state
        distance = diameter - x
        arm = diameter if radius_arm else distance
        sliding = (arm * spin - distance * angle_rate) / diameter
        push = x if x > 0 else 0.0
        swing = angle_rate / diameter
        repulsion = push**1.5 + alpha * push**0.25 * rate
        # m* = m/2 and I = m diameter^2/10 of one sphere; angle_rate and spin carry a factor diameter.
        turn = diameter * (f + 2 * rate * swing) / distance
        spin_up = -2.5 * f * arm / diameter
        return np.array([rate, -repulsion - distance * swing**2, turn, spin_up, swing]), sliding

    tangential = offset / cosine
    start = [0.0, 1.0, 0.0, tangential, 0.0, np.arcsin(offset)]
    state, time = StickSlip(friction, motion).run(start)
    x, rate, _, angle_rate, spin, angle = state
    normal, tangent = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    speed = angle_rate * (diameter - x) / diameter
    # Orbit m* D^2 swing and two spins I w, over m* D.
    momentum = speed * (diameter - x) / diameter + 0.4 * spin
    return -rate * normal + speed * tangent, spin, time, momentum / tangential
