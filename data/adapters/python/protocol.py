"""The protocol of docs/protocol.md: one request a line, one reply a line. `serve` is all that a program of yours needs."""
import json
import sys


def read(value):
    """Numbers come as hexadecimal floats in strings, "inf" among them; other words stay."""
    if isinstance(value, list):
        return [read(x) for x in value]
    if isinstance(value, dict):
        return {key: read(x) for key, x in value.items()}
    is_number = isinstance(value, str) and (value == "inf" or value.lstrip("-").startswith("0x"))
    return float.fromhex(value) if is_number else value


def written(value):
    if isinstance(value, list):
        return [written(x) for x in value]
    if isinstance(value, dict):
        return {key: written(x) for key, x in value.items()}
    return value.hex() if isinstance(value, float) else value


def reply(request, operations):
    operation = operations.get(request["op"])
    if operation is None:
        return {"skip": "unknown_op"}
    try:
        out = operation(**read(request["in"]))
    except (ArithmeticError, ValueError) as problem:  # 0/0, a root of what should not be negative
        return {"error": "no_answer", "message": str(problem)}
    return {"out": written(out)}


def serve(name, operations, bits=53, **more):
    """`more` goes into the answer to hello: features=[…], what its questions have and have not."""
    for line in sys.stdin:
        request = json.loads(line)
        if "bye" in request:
            return
        hello = {"name": name, "ops": list(operations), "bits": bits, **more}
        answer = hello if "hello" in request else {"seq": request["seq"], **reply(request, operations)}
        print(json.dumps(answer), flush=True)
