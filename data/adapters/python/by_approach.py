"""Eq. (2) with the paper's b^2 - 4ac, for pairs that approach (blocking) or separate (tethering)."""
import math

from protocol import serve
from timing import dot, minus


def coefficients(u_A, u_B, v_A, v_B, L):
    r, v = minus(u_B, u_A), minus(v_B, v_A)
    a, b, c = dot(v, v), 2 * dot(r, v), dot(r, r) - L * L
    return a, b, c, b * b - 4 * a * c


def block_time(**query):
    a, b, c, discriminant = coefficients(**query)
    if a == 0 or b >= 0:
        return {"verdict": "static" if a == 0 else "receding", "t": None}
    if c <= 0:
        return {"verdict": "overlap" if c < 0 else "contact", "t": 0}
    if discriminant <= 0:
        return {"verdict": "miss" if discriminant < 0 else "tangent", "t": None}
    return {"verdict": "hit", "t": (-b - math.sqrt(discriminant)) / (2 * a)}


def tether_time(**query):
    a, b, c, discriminant = coefficients(**query)
    if a == 0:
        return {"verdict": "static", "t": None}
    if c >= 0 and b >= 0:
        return {"verdict": "overstretched" if c > 0 else "taut", "t": 0}
    if c > 0 and discriminant <= 0:
        return {"verdict": "turning", "t": -b / (2 * a)}
    return {"verdict": "hit", "t": (-b + math.sqrt(discriminant)) / (2 * a)}


if __name__ == "__main__":
    serve("by approach", {"block_time": block_time, "tether_time": tether_time})
