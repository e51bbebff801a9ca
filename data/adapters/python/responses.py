"""Eqs. (3) to (7) in plain doubles."""
import math

from protocol import serve
from timing import dot, minus


def reduced_mass(m_A, m_B):
    return 1 / (1 / m_A + 1 / m_B)


def frame(u_A, u_B, v_A, v_B):
    """The axis, the relative velocity, its part along the axis and that across it."""
    r, v = minus(u_B, u_A), minus(v_B, v_A)
    distance = math.sqrt(dot(r, r))
    n = [x / distance for x in r]
    v_n = dot(v, n)
    return n, v, v_n, [x - v_n * y for x, y in zip(v, n)]


def apply_impulse(m_A, m_B, v_A, v_B, dp):
    return {"v_A": [v + p / m_A for v, p in zip(v_A, dp)], "v_B": [v - p / m_B for v, p in zip(v_B, dp)]}


def collision_impulse(m_A, m_B, c, **pair):
    n, _, v_n, _ = frame(**pair)
    return {"dp": [(1 + c) * reduced_mass(m_A, m_B) * (v_n * x) for x in n]}


def slope(degrees):
    return math.tan(math.radians(degrees)) if degrees <= 45 else 1 / math.tan(math.radians(90 - degrees))


def revolution_impulse(m_A, m_B, c_revolve, theta_revolve_deg, **pair):
    n, v, _, w = frame(**pair)
    inward = slope(theta_revolve_deg) * math.sqrt(dot(w, w))
    direction = [x - inward * y for x, y in zip(w, n)]
    length = math.sqrt(dot(direction, direction))
    speed = c_revolve ** (theta_revolve_deg / 180) * math.sqrt(dot(v, v))
    return {"dp": [reduced_mass(m_A, m_B) * (x - speed * (y / length)) for x, y in zip(v, direction)]}


def tether_response(m_A, m_B, c_retract, c_revolve, theta_revolve_deg, **pair):
    _, _, v_n, w = frame(**pair)
    across = math.sqrt(dot(w, w))
    if across == 0 or abs(c_retract * v_n) > slope(theta_revolve_deg) * across:
        kind, dp = "retract", collision_impulse(m_A, m_B, c_retract, **pair)["dp"]
    else:
        kind, dp = "revolve", revolution_impulse(m_A, m_B, c_revolve, theta_revolve_deg, **pair)["dp"]
    return {"kind": kind, "dp": dp, **apply_impulse(m_A, m_B, pair["v_A"], pair["v_B"], dp)}


def load(m_A, m_B, v_A, v_B):
    return {"v_load": [1 / (1 + m_B / m_A) * a + 1 / (1 + m_A / m_B) * b for a, b in zip(v_A, v_B)]}


def restitution_impulse(m_A, m_B, v_A, v_B, dp):
    return {"dp_AB": [p - reduced_mass(m_A, m_B) * v for p, v in zip(dp, minus(v_B, v_A))]}


OPERATIONS = {f.__name__: f for f in (apply_impulse, collision_impulse, revolution_impulse, tether_response, load, restitution_impulse)}
if __name__ == "__main__":
    serve("Python, responses", OPERATIONS)
