"""Effects beyond the paper: a plane wall, the clock under drag, rebounds of rough discs and spheres (docs/effects.md)."""
import math

from protocol import serve
from responses import apply_impulse, collision_impulse, frame, reduced_mass
from timing import dot, minus


def wall_time(u_A, u_B, v_A, v_B, L, normal):
    """At distance L of the plane through A, and approaching."""
    v, gap = minus(v_B, v_A), dot(normal, minus(u_B, u_A)) - L
    towards = -dot(normal, v)
    if not any(v) or towards <= 0:
        return {"verdict": "receding" if any(v) else "static", "t": None}
    if gap <= 0:
        return {"verdict": "overlap" if gap < 0 else "contact", "t": 0}
    return {"verdict": "hit", "t": gap / towards}


def drag_time(gamma, s):
    """t of the clock s = (1 - e^(-gamma t))/gamma, which ends at 1/gamma."""
    if gamma * s >= 1:
        return {"verdict": "never", "t": None}
    return {"verdict": "reached", "t": -math.log1p(-gamma * s) / gamma}


def cross(x, y):
    if len(x) == 3:
        return [x[k - 2] * y[k - 1] - x[k - 1] * y[k - 2] for k in range(3)]
    return [x[0] * y[1] - x[1] * y[0]]


def turned(spin, x):
    return cross(spin, x) if len(x) == 3 else [-spin[0] * x[1], spin[0] * x[0]]


def rough_impulse(spin_A, spin_B, m_A, m_B, R_A, R_B, c, mu, beta0, **pair):
    """The smaller of what holds the surfaces and of what friction can, across the axis; spins are numbers in the plane."""
    is_planar = len(pair["u_A"]) == 2
    spins = [[spin_A], [spin_B]] if is_planar else [spin_A, spin_B]
    n, _, _, w = frame(**pair)
    K = 1 / 2 if is_planar else 2 / 5
    g = minus(w, turned([R_A * x + R_B * y for x, y in zip(*spins)], n))
    normal = collision_impulse(m_A, m_B, c, **pair)["dp"]
    slip, factor = math.sqrt(dot(g, g)), (1 + beta0) * K / (1 + K) * reduced_mass(m_A, m_B)
    most = mu * math.sqrt(dot(normal, normal))
    sticks = factor * slip <= most
    across = [factor * x if sticks else most * (x / slip) for x in g]
    dp, turn = [x + y for x, y in zip(normal, across)], cross(n, across)
    after = [[w + t / (K * m * R) for w, t in zip(spin, turn)] for spin, m, R in zip(spins, (m_A, m_B), (R_A, R_B))]
    spin_A, spin_B = (w[0] if is_planar else w for w in after)
    return {"kind": "sticks" if sticks else "slides", "dp": dp, "spin_A": spin_A, "spin_B": spin_B,
            **apply_impulse(m_A, m_B, pair["v_A"], pair["v_B"], dp)}


OPERATIONS = {f.__name__: f for f in (wall_time, drag_time, rough_impulse)}
if __name__ == "__main__":
    serve("Python, effects", OPERATIONS)
