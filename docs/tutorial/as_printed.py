"""When two particles collide: eq. (2) of the paper, asked over a pipe."""
import json
import math
import sys


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def collision_time(u_A, u_B, v_A, v_B, L):
    """The smaller real, non-negative root of a t^2 + b t + c = 0, the times at distance L."""
    r = [number(B) - number(A) for A, B in zip(u_A, u_B)]
    v = [number(B) - number(A) for A, B in zip(v_A, v_B)]
    a = sum(x * x for x in v)
    b = 2 * sum(x * y for x, y in zip(r, v))
    c = sum(x * x for x in r) - number(L) * number(L)
    if a == 0:
        return {"verdict": "static", "t": None}
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return {"verdict": "miss", "t": None}
    root = math.sqrt(discriminant)
    ahead = [t for t in ((-b - root) / (2 * a), (-b + root) / (2 * a)) if t >= 0]
    if not ahead:
        return {"verdict": "receding", "t": None}
    return {"verdict": "hit", "t": min(ahead).hex()}


OPERATIONS = {"block_time": collision_time, "tether_time": collision_time}

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
