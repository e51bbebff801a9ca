"""The paper's loop: find the next collision of any pair, advance everybody, respond.

python3 paper_loop.py SCENE > TRACE, or without a scene as the operations `simulate` and `next_event` of the protocol. It knows
blocking, tethering, infinite masses, tethers that form and break by rules without a draw; it does not know grouping, phases,
impulses from outside.
"""
import json
import math
import sys

from pairs import Pairs
from protocol import read, serve
from responses import apply_impulse


def run(scene, max_events=math.inf):
    """The lines of a minimal trace (docs/check.md)."""
    pairs, start, duration = Pairs(scene), read(scene.get("start_time", 0)), read(scene["duration"])
    clock, events, still = 0.0, 0, 0  # since the start; the trace has the scene's clock
    yield {"trace": 1, "form": "minimal", "positions": "eager", "scene": scene}
    while still <= 10000 + len(pairs.u) * (len(pairs.u) - 1) // 2:
        t, limit, i, j = first_due(pairs)
        if t == math.inf:
            return (yield {"end": "no_more_events", "events": events, "t": start + clock})
        if events >= max_events:
            return (yield {"end": "max_events", "events": events, "t": start + clock})
        if clock + t > duration:
            return (yield {"end": "duration", "events": events, "t": start + duration})
        still = still + 1 if clock + t == clock else 0
        clock, events = clock + t, events + 1
        yield {"t": start + clock, **event(pairs, t, limit, i, j)}
    yield {"end": "stalled", "events": events, "t": start + clock}


def next_event(scene):
    """What happens first, and where everybody is then."""
    pairs = Pairs(scene)
    t, limit, i, j = first_due(pairs)
    happens = {"kind": "none"} if t == math.inf else {"dt": t, **event(pairs, t, limit, i, j)}
    state = [{"id": n, "position": u, "velocity": v} for n, u, v in zip(pairs.ids, pairs.u, pairs.v)]
    return {**{key: value for key, value in happens.items() if key != "post"}, "state": state}


def first_due(pairs):
    times = [(t, pairs.ids[i], pairs.ids[j], limit, i, j) for i, j in pairs.laws for t, limit in pairs.due(i, j) if t is not None]
    t, _, _, limit, i, j = min(times, default=(math.inf, 0, 0, "", 0, 0))
    return t, limit, i, j


def event(pairs, t, limit, i, j):
    """Everybody flies for t, then the pair responds."""
    pairs.u = [[x + w * t for x, w in zip(place, speed)] for place, speed in zip(pairs.u, pairs.v)]
    kind, dp, tether = pairs.respond(i, j, limit)
    before = pairs.v[i], pairs.v[j]
    pairs.v[i], pairs.v[j] = after = tuple(apply_impulse(pairs.m[i], pairs.m[j], *before, dp).values())
    if after != before:  # an impulse may be less than the last digit of both
        pairs.answered = {known for known in pairs.answered if not {i, j} & set(known[:2])}
    pairs.answered.add((i, j, limit))
    if tether:
        (pairs.tethers.add if tether == "formed" else pairs.tethers.remove)((i, j))
    post = {str(pairs.ids[k]): {"velocity": pairs.v[k]} for k in (i, j)}
    return {"kind": kind, "i": pairs.ids[i], "j": pairs.ids[j], "post": post, **({"tether": tether} if tether else {})}


if __name__ == "__main__":
    if len(sys.argv) > 1:
        for line in run(json.load(open(sys.argv[1], encoding="utf-8"))):
            print(json.dumps(line))
    else:
        serve("the paper's loop", {"simulate": lambda scene, max_events: {"trace": list(run(scene, max_events))}, "next_event": next_event},
              features=["no-groups", "no-draws", "no-phases", "no-impulses"])
