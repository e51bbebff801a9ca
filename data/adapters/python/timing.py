"""Eq. (2) without the cancellations of the printed form (docs/eq2.md), and the order of two events."""
import math

from protocol import serve


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def quadratic(u_A, u_B, v_A, v_B, L):
    """a, h = b/2, c and D = h^2 - ac of the quadratic whose roots are the times at distance L."""
    r, v = minus(u_B, u_A), minus(v_B, v_A)
    a, h, distance = dot(v, v), dot(r, v), math.sqrt(dot(r, r))
    c = (distance - L) * (distance + L)
    across = [r[i] * v[j] - r[j] * v[i] for j in range(len(r)) for i in range(j)]
    D = h * h - a * c if h * h < a * L * L else a * L * L - dot(across, across)
    return a, h, c, D


def block_time(**query):
    """At distance L and approaching: the smaller root."""
    a, h, c, D = quadratic(**query)
    if a == 0 or h >= 0:
        return {"verdict": "static" if a == 0 else "receding", "t": None}
    if c <= 0:
        return {"verdict": "overlap" if c < 0 else "contact", "t": 0}
    if D <= 0:
        return {"verdict": "miss" if D < 0 else "tangent", "t": None}
    return {"verdict": "hit", "t": c / (-h + math.sqrt(D))}


def tether_time(**query):
    """At distance L and separating: the larger root."""
    a, h, c, D = quadratic(**query)
    if a == 0:
        return {"verdict": "static", "t": None}
    if c >= 0 and h >= 0:
        return {"verdict": "overstretched" if c > 0 else "taut", "t": 0}
    if c > 0 and D <= 0:
        return {"verdict": "turning", "t": -h / a}
    return {"verdict": "hit", "t": -c / (h + math.sqrt(D)) if h > 0 else (-h + math.sqrt(D)) / a}


def time(kind, **query):
    t = (block_time if kind == "block" else tether_time)(**query)["t"]
    return math.inf if t is None else t


def order(first, second):
    one, other = time(**first), time(**second)
    return {"order": "before" if one < other else "after" if other < one else "none" if one == math.inf else "equal"}


OPERATIONS = {"block_time": block_time, "tether_time": tether_time, "order": order}
if __name__ == "__main__":
    serve("Python, timing", OPERATIONS)
