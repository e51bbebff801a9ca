"""A small implementation of the protocol (docs/protocol.md): eqs. (3), (4) and (6) in doubles, right or wrong in one way.

usage: implementation.py right | half_rebound | sign | crash | exit | hang | garbage | wrong_seq | truncated | nan
       | short_vector | no_hello | only_load_offered | no_rebound
"""

import json
import math
import os
import signal
import sys
import time

MODE = sys.argv[1]


def read(value):
    if isinstance(value, list):
        return [read(x) for x in value]
    return float.fromhex(value) if isinstance(value, str) else value


def written(vector):
    return [x.hex() for x in vector]


def apply_impulse(m_A, m_B, v_A, v_B, dp):
    sign = 1 if MODE == "sign" else -1
    return {"v_A": written(v + p / m_A for v, p in zip(v_A, dp)),
            "v_B": written(v + sign * p / m_B for v, p in zip(v_B, dp))}


def collision_impulse(u_A, u_B, v_A, v_B, m_A, m_B, c):
    r = [b - a for a, b in zip(u_A, u_B)]
    v = [b - a for a, b in zip(v_A, v_B)]
    distance = math.sqrt(sum(x * x for x in r))
    n = [x / distance for x in r]
    normal = sum(x * y for x, y in zip(v, n))
    factor = c if MODE == "half_rebound" else 1 + c
    mu = 1 / (1 / m_A + 1 / m_B)
    return {"dp": written(factor * mu * (normal * x) for x in n)}


def load(m_A, m_B, v_A, v_B):
    # inf/m is inf, 1/(1 + inf) is 0
    return {"v_load": written(1 / (1 + m_B / m_A) * a + 1 / (1 + m_A / m_B) * b for a, b in zip(v_A, v_B))}


def rough_impulse(v_A, v_B, spin_A, spin_B, **_):
    return {"kind": "slides", "dp": written([0.0] * len(v_A)), "v_A": written(v_A), "v_B": written(v_B),
            "spin_A": spin_A.hex() if len(v_A) == 2 else written(spin_A),
            "spin_B": spin_B.hex() if len(v_A) == 2 else written(spin_B)}


OPERATIONS = {"apply_impulse": apply_impulse, "collision_impulse": collision_impulse, "load": load}
if MODE == "no_rebound":
    OPERATIONS["rough_impulse"] = rough_impulse


def reply_to(request):
    if "hello" in request:
        return json.dumps({"version": 1} if MODE == "no_hello" else
                          {"name": "python", "bits": 53} | ({"ops": ["load"]} if MODE == "only_load_offered" else {}))
    seq, op = request["seq"], request["op"]
    if MODE == "only_load_offered" and op != "load":
        return json.dumps({"seq": seq, "error": "bad_input", "message": "not offered"})
    if op not in OPERATIONS:
        return json.dumps({"seq": seq, "skip": "unknown_op"})
    if MODE == "crash":
        os.kill(os.getpid(), signal.SIGSEGV)
    if MODE == "exit":
        sys.exit(3)
    if MODE == "hang":
        time.sleep(1000)
    if MODE == "garbage":
        return "Traceback (most recent call last):"
    try:
        out = OPERATIONS[op](**{key: read(value) for key, value in request["in"].items()})
    except ArithmeticError as error:
        return json.dumps({"seq": seq, "error": str(error)})
    if MODE == "nan":
        out = {key: ["nan"] * len(vector) for key, vector in out.items()}
    if MODE == "short_vector":
        out = {key: vector[:1] for key, vector in out.items()}
    reply = json.dumps({"seq": seq + 1 if MODE == "wrong_seq" else seq, "out": out})
    if MODE == "truncated":
        sys.stdout.write(reply[:20])
        sys.stdout.flush()
        sys.exit(0)
    return reply


for line in sys.stdin:
    message = json.loads(line)
    if "bye" in message:
        break
    print(reply_to(message), flush=True)
