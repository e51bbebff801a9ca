"""A small implementation of the protocol (docs/protocol.md): eqs. (3), (4) and (6) in doubles, right or wrong in one way.

usage: implementation.py right | half_rebound | sign | crash | exit | hang | garbage | wrong_seq | truncated | nan
       | short_vector | no_hello
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


OPERATIONS = {"apply_impulse": apply_impulse, "collision_impulse": collision_impulse, "load": load}


def reply_to(request):
    if "hello" in request:
        return json.dumps({"version": 1} if MODE == "no_hello" else {"name": "python", "bits": 53})
    seq, op = request["seq"], request["op"]
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
