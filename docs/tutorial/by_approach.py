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
    c = sum(x * x for x in r) - L * L
    return a, h, c, h * h - a * c


def block_time(**query):
    """At distance L and approaching: the smaller root."""
    a, h, c, D = quadratic(**query)
    if a == 0 or h >= 0:
        return {"verdict": "static" if a == 0 else "receding", "t": None}
    if c <= 0:
        return {"verdict": "overlap" if c < 0 else "contact", "t": 0}
    if D <= 0:
        return {"verdict": "miss" if D < 0 else "tangent", "t": None}
    return {"verdict": "hit", "t": ((-h - math.sqrt(D)) / a).hex()}


def tether_time(**query):
    """At distance L and separating: the larger root."""
    a, h, c, D = quadratic(**query)
    if a == 0:
        return {"verdict": "static", "t": None}
    if c >= 0 and h >= 0:
        return {"verdict": "overstretched" if c > 0 else "taut", "t": 0}
    if c > 0 and D <= 0:
        return {"verdict": "turning", "t": (-h / a).hex()}
    return {"verdict": "hit", "t": ((-h + math.sqrt(max(D, 0))) / a).hex()}


OPERATIONS = {"block_time": block_time, "tether_time": tether_time}

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
