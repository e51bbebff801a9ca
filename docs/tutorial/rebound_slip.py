"""When two particles collide: eq. (2) of the paper, asked over a pipe."""
import json
import math
import sys


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def quadratic(u_A, u_B, v_A, v_B, L):
    """a, h = b/2, c and D = h^2 - ac of the quadratic whose roots are the times at distance L."""
    r = [number(B) - number(A) for A, B in zip(u_A, u_B)]
    v = [number(B) - number(A) for A, B in zip(v_A, v_B)]
    L = number(L)
    a = sum(x * x for x in v)
    h = sum(x * y for x, y in zip(r, v))
    distance = math.sqrt(sum(x * x for x in r))
    c = (distance - L) * (distance + L)
    minors = [r[i] * v[j] - r[j] * v[i] for j in range(len(r)) for i in range(j)]
    D = h * h - a * c if h * h < a * L * L else a * L * L - sum(x * x for x in minors)
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
    return {"verdict": "hit", "t": (c / (-h + math.sqrt(D))).hex()}


def tether_time(**query):
    """At distance L and separating: the larger root."""
    a, h, c, D = quadratic(**query)
    if a == 0:
        return {"verdict": "static", "t": None}
    if c >= 0 and h >= 0:
        return {"verdict": "overstretched" if c > 0 else "taut", "t": 0}
    if c > 0 and D <= 0:
        return {"verdict": "turning", "t": (-h / a).hex()}
    if h > 0:
        return {"verdict": "hit", "t": (-c / (h + math.sqrt(max(D, 0)))).hex()}
    return {"verdict": "hit", "t": ((-h + math.sqrt(max(D, 0))) / a).hex()}


def collision_impulse(u_A, u_B, v_A, v_B, m_A, m_B, c):
    """Eq. (4): along the axis, for the approach to be turned by the coefficient of restitution."""
    r = [number(B) - number(A) for A, B in zip(u_A, u_B)]
    v = [number(B) - number(A) for A, B in zip(v_A, v_B)]
    distance = math.sqrt(sum(x * x for x in r))
    axis = [x / distance for x in r]
    approach = sum(x * y for x, y in zip(v, axis))
    reduced_mass = 1 / (1 / number(m_A) + 1 / number(m_B))
    return {"dp": [(number(c) * reduced_mass * (approach * x)).hex() for x in axis]}


OPERATIONS = {"block_time": block_time, "tether_time": tether_time, "collision_impulse": collision_impulse}

for line in sys.stdin:
    request = json.loads(line)
    if "hello" in request:
        reply = {"name": "mine"}
    elif "bye" in request:
        break
    elif request["op"] in OPERATIONS:
        reply = {"seq": request["seq"], "out": OPERATIONS[request["op"]](**request["in"])}
    else:
        reply = {"seq": request["seq"], "skip": "unknown_op"}
    print(json.dumps(reply), flush=True)
