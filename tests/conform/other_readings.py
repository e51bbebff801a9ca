#!/usr/bin/env python3
"""A right simulator that decides otherwise where the paper is silent (docs/decisions.md): `tps conform` calls it so, and not wrong. And two
that are wrong about groups, of which the paper's examples say enough.

  other_readings.py READING SCENE > TRACE, READING one of READINGS

The simulator is that of tests/trace_check/liar, which shares nothing with the reference.
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "trace_check" / "liar"))
from groups import Forest  # noqa: E402
from honesty import Honesty  # noqa: E402
from responses import collision_impulse  # noqa: E402
from simulator import Simulator  # noqa: E402
from timing import INNER, OUTER  # noqa: E402


class WallJoins(Honesty):
    """D9: an infinite mass that is hit in a group joins its tree, and is listed with it."""

    def begin(self, sim):
        if sim.forest:
            sim.forest = ForestOfAll()


class ForestOfAll(Forest):
    def side(self, i, fixed):
        return super().side(i, False)

    def join(self, node, fixed, expiry, now):
        return super().join(node, (False, False), expiry, now)


class AsksAgain(Honesty):
    """D11: no pair is passed over for having rebounded."""

    def begin(self, sim):
        asked_no_more = sim.has_responded
        sim.has_responded = lambda i, j, limit: limit == OUTER and asked_no_more(i, j, limit)


class Attracts(Honesty):
    """D12: the impulse of (4) whatever the sign of v_n."""

    def impulse(self, sim, hit):
        if hit.limit == INNER and hit.frame.normal > 0:
            c = float(sim.laws.blocking(hit.i, hit.j)["c_rebound"])
            hit.dp, hit.answered = collision_impulse(hit.frame, hit.m_i, hit.m_j, c), True


class LastOfTies(Honesty):
    """D13: of several events at one time the last by ids."""

    def chosen(self, sim, event, events):
        return max((e for e in events if e.time == event.time and e.rank == event.rank), key=lambda e: (e.i, e.j))


class DoesNotPull(Honesty):
    """D16: no impulse for a taut pair that approaches by rounding."""

    def impulse(self, sim, hit):
        if hit.limit == OUTER and hit.frame.normal < 0:
            hit.dp, hit.answered = tuple(0.0 for _ in hit.dp), False


class OwnExpiry(Honesty):
    """D10: a later load does not renew the expiry of the tree that it joins."""

    def expiry(self, sim, hit, expiry):
        return min([body.expiry for i in (hit.i, hit.j) if (body := sim.forest.body(i))], default=expiry)


class LeavesFirst(Honesty):
    """Restitutes the first load first."""

    def unwinding(self, sim, body, nodes):
        return nodes[::-1]


READINGS = {"none": Honesty, "D9": WallJoins, "D11": AsksAgain, "D12": Attracts, "D13": LastOfTies, "D16": DoesNotPull, "expiry": OwnExpiry, "unwinding": LeavesFirst}


def main():
    reading, path = sys.argv[1:]
    scene = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    print(Simulator(scene, "certified", lie=READINGS[reading]()).run(2000).text(minimal=True), end="")


if __name__ == "__main__":
    main()
