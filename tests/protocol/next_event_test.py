"""The next event of scenes that graze, nearly tie and tie exactly, asked of `tps serve` and judged by integers alone.

next_event_test.py PROGRAM SOURCE_DIR
"""
import json, math, os, random, subprocess, sys

program, source = sys.argv[1:]
sys.path.insert(0, os.path.join(source, "data"))
import verify_vectors as exact

PAIR = {"between": ["a", "a"], "blocking": {"distance": (1.0).hex(), "c_rebound": (1.0).hex()}}


def scene(particles):
    return {"tps": 1, "dimension": 2, "duration": 1000, "species": {"a": {"mass": "0x1p+0", "radius": "0x1p-1"}}, "pairs": [PAIR],
            "particles": [{"id": n, "species": "a", "position": [x.hex() for x in u], "velocity": [x.hex() for x in v]}
                          for n, (u, v) in enumerate(particles)]}


def graze(rng):
    """Passes at a distance within 2^-60 to 2^-20 of the limit, from a random side."""
    angle, way = rng.uniform(0, 2 * math.pi), rng.uniform(2, 60)
    off = 1 + rng.choice([-1, 1]) * 2.0 ** rng.uniform(-56, -20)
    c, s = math.cos(angle), math.sin(angle)
    return scene([([0.0, 0.0], [0.0, 0.0]), ([way * c - off * s, way * s + off * c], [-c, -s])])


def near_tie(rng):
    """Two pairs whose events are a few ulps apart, or at one time."""
    gap, speed, ulps = rng.uniform(1.5, 3), rng.uniform(0.5, 2), rng.choice([0, 0, 1, -1, 2, -2])
    other = gap
    for _ in range(abs(ulps)):
        other = math.nextafter(other, math.inf if ulps > 0 else 0)
    tilt = rng.uniform(-0.5, 0.5)
    return scene([([0.0, 0.0], [speed, tilt]), ([gap, 0.0], [0.0, tilt]), ([0.0, 64.0], [speed, 0.0]), ([other, 64.0], [0.0, 0.0])])


def first_of(which):
    possible = [e for e in exact.limits(which) if e[4].verdict not in exact.NEVER]
    best = None
    for event in possible:
        order = "before" if best is None else exact.order(event[4], best[4])
        if order == "before" or (order == "equal" and (event[1], event[2]) < (best[1], best[2])):
            best = event
    return best


def is_nearest(query, t):
    def side(x, y):
        (n, d), (m, e) = x.as_integer_ratio(), y.as_integer_ratio()
        return query.side(n * e + m * d, 2 * d * e)
    return side(math.nextafter(t, -math.inf), t) <= 0 <= side(t, math.nextafter(t, math.inf))


def wrong_in(which, out):
    first = first_of(which)
    if first is None:
        return None if out["kind"] == "none" else "nothing happens"
    _, i, j, kind, query = first
    if (out["kind"], out.get("i"), out.get("j")) != ("rebound", i, j):
        return f"the event is of {i} and {j}"
    if query.verdict in exact.NOW:
        return None if out["dt"] == "0x0p+0" else "dt is 0"
    return None if is_nearest(query, float.fromhex(out["dt"])) else "dt is not the nearest double"


rng = random.Random(20260101)
scenes = [make(rng) for make in (graze, near_tie) for _ in range(400)]
requests = "".join(json.dumps({"seq": n, "op": "next_event", "in": {"scene": s}}) + "\n" for n, s in enumerate(scenes))
replies = subprocess.run([program, "serve"], input=requests, capture_output=True, text=True, check=True).stdout.splitlines()
assert len(replies) == len(scenes)
wrong, kinds, tied = [], {}, 0
for which, reply in zip(scenes, map(json.loads, replies)):
    if "out" not in reply:
        wrong.append(json.dumps(reply))
        continue
    kinds[reply["out"]["kind"]] = kinds.get(reply["out"]["kind"], 0) + 1
    tied += reply["out"].get("tied", False)
    if found := wrong_in(which, reply["out"]):
        wrong.append(f"{found}: {json.dumps(reply)} {json.dumps(which)}")
print(f"{len(scenes)} scenes, {kinds}, {tied} ties, {len(wrong)} wrong")
if wrong or kinds.get("none", 0) < 100 or kinds.get("rebound", 0) < 500 or tied < 50:
    sys.exit("\n".join(wrong[:3]))
