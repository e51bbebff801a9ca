"""Eqs. (3) to (7) in doubles, with the formulas of docs/eq3.md to docs/eq7.md."""
import math

from numbers_of_traces import dot, minus, norm, plus, times


class Frame:
    """A collision seen from A: û, v_AB, v_n, v_û, v_ŵ."""

    def __init__(self, u_a, u_b, v_a, v_b):
        r = minus(u_b, u_a)
        distance = norm(r)
        self.axis = tuple(x / distance for x in r)
        self.relative = minus(v_b, v_a)
        self.normal = dot(self.relative, self.axis)
        self.along = times(self.normal, self.axis)
        rest = minus(self.relative, self.along)
        across = plus(rest, self.axis, -dot(rest, self.axis))
        only_rounding = dot(across, across) < dot(rest, rest) / 4
        self.across = tuple(0.0 for _ in across) if only_rounding else across


def reduced_mass(m_a, m_b):
    return 1 / (1 / m_a + 1 / m_b)


def tangent(degrees):
    if degrees == 45:
        return 1.0
    return math.tan(math.radians(degrees)) if degrees < 45 else 1 / math.tan(math.radians(90 - degrees))


def collision_impulse(frame, m_a, m_b, c):
    return times((1 + c) * reduced_mass(m_a, m_b), frame.along)


def revolution_impulse(frame, m_a, m_b, c_revolve, degrees, exponent=None, slope=None):
    speed_across = norm(frame.across)
    slope = tangent(degrees) if slope is None else slope
    direction = plus(frame.across, frame.axis, -slope * speed_across)
    size = norm(direction)
    factor = (c_revolve ** (degrees / 180) if exponent is None else exponent) * norm(frame.relative)
    new = tuple(factor * x / size for x in direction)
    return times(reduced_mass(m_a, m_b), minus(frame.relative, new))


def retraction_suffices(frame, c_retract, degrees):
    across = norm(frame.across)
    return across == 0 or abs(c_retract * frame.normal) > tangent(degrees) * across


def apply_impulse(m_a, m_b, v_a, v_b, dp):
    return tuple(v + p / m_a for v, p in zip(v_a, dp)), tuple(v - p / m_b for v, p in zip(v_b, dp))


def load_velocity(m_a, m_b, v_a, v_b):
    w_a, w_b = 1 / (1 + m_b / m_a), 1 / (1 + m_a / m_b)
    return tuple(w_a * a + w_b * b for a, b in zip(v_a, v_b))


def restitution_impulse(m_a, m_b, v_a, v_b, dp):
    return minus(dp, times(reduced_mass(m_a, m_b), minus(v_b, v_a)))
