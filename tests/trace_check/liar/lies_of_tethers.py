"""Lies about tethers: forming, breaking, draws, phases."""

from lie import Lie, lie
from numbers_of_traces import norm, off_by
from responses import collision_impulse
from timing import INNER, OUTER


class Tether(Lie):
    """Another decision about a tether than the rule's."""

    def tether(self, sim, hit):
        if self.now(sim) and sim.laws.tethering(hit.i, hit.j) and not sim.laws.permanent(hit.i, hit.j):
            if self.instead(sim, hit, (hit.i, hit.j)):
                self.tell()


@lie("tethers", "sticky sticky_grouped", minimal=True, until=60)
class FormedUnrecorded(Tether):
    def instead(self, sim, hit, pair):
        return hit.record.pop("tether", None) == "formed" or hit.record.update(self.put_back(sim, hit))

    def put_back(self, sim, hit):
        return {"tether": "broken"} if hit.kind == "break" else {}


@lie("tethers", "sticky sticky_grouped", minimal=True, until=60)
class NotFormed(Tether):
    """Nothing is formed where it must, and nothing is recorded."""

    def instead(self, sim, hit, pair):
        if hit.record.get("tether") != "formed":
            return False
        del hit.record["tether"]
        sim.tethers.discard(pair)
        return True


@lie("states earliest bounds contact end tethers", "sticky sticky_grouped", minimal=True, until=90)
class RecordedNotFormed(Tether):
    """The record says "formed", the simulation knows of no tether."""

    def instead(self, sim, hit, pair):
        sim.tethers.discard(pair) if hit.record.get("tether") == "formed" else None
        return hit.record.get("tether") == "formed"


@lie("tethers", "sticky sticky_grouped", minimal=True, until=60)
class CapacityIgnored(Tether):
    def instead(self, sim, hit, pair):
        if hit.limit == INNER and pair not in sim.tethers and any(map(sim.is_full, pair)):
            sim.tethers.add(pair)
            hit.record["tether"] = "formed"
            return True
        return False


@lie("tethers", "chain chain_grouped", minimal=True)
class BreaksThoughNever(Tether):
    def instead(self, sim, hit, pair):
        if hit.limit != OUTER:
            return False
        hit.kind, hit.record["tether"] = "break", "broken"
        sim.tethers.discard(pair)
        return True


@lie("tethers", "sticky sticky_grouped", minimal=True, until=90)
class BreakIgnored(Tether):
    """A tether that has to break pulls instead."""

    def instead(self, sim, hit, pair):
        if hit.kind != "break" or not hit.answered:
            return False
        hit.kind = "retract"
        del hit.record["tether"]
        sim.tethers.add(pair)
        hit.dp = collision_impulse(hit.frame, hit.m_i, hit.m_j, sim.laws.tethering(*pair)["c_retract"])
        return True


@lie("tethers", "lottery lottery_grouped", minimal=True)
class DrawDisobeyed(Tether):
    """The draw says one thing, the tether does the other: at forming."""

    def instead(self, sim, hit, pair):
        if "draw" not in hit.record or hit.limit != INNER:
            return False
        if hit.record.pop("tether", None):
            sim.tethers.discard(pair)
        else:
            sim.tethers.add(pair)
            hit.record["tether"] = "formed"
        return True


@lie("tethers", "lottery lottery_grouped")
class DrawMissing(Tether):
    def instead(self, sim, hit, pair):
        return hit.record.pop("draw", None) is not None


@lie("tethers", "lottery lottery_grouped")
class DrawOfAnotherSeed(Tether):
    """The decision follows the draw, but the draw is not that of the header's seed."""

    def instead(self, sim, hit, pair):
        if "draw" not in hit.record or hit.limit != INNER:
            return False
        draw = (hit.record["draw"] + 0.5) % 1
        formed = draw < sim.laws.rule(*pair, "form")["probability"]
        hit.record.pop("tether", None)
        sim.tethers.discard(pair)
        if formed:
            sim.tethers.add(pair)
            hit.record["tether"] = "formed"
        hit.record["draw"] = draw
        return True


@lie("tethers", "sticky sticky_grouped", minimal=True, until=60)
class PhaseIgnored(Lie):
    """The phases are told, the rules stay."""

    def __init__(self, first):
        super().__init__(0)

    def phase(self, sim, opens, phase):
        return False

    def tether(self, sim, hit):
        """Told where the phase's rule would have decided otherwise."""
        pair, which = (hit.i, hit.j), "form" if hit.limit == INNER else "break"
        law = sim.laws.tethering(*pair)
        if self.told or not law or sim.laws.permanent(*pair):
            return
        due = [p[which] for p in sim.scene["phases"] if float(p["from"]) <= sim.now[0] and
               (p["until"] == "inf" or sim.now[0] < float(p["until"])) and set(p["between"]) == set(sim.laws.pair(*pair)["between"])]
        could = which == "break" or ("tether" in hit.record or (pair not in sim.tethers and not any(map(sim.is_full, pair))))
        changed = hit.record.get("tether") is not None
        if due and could and changed != (due[-1] == "always"):
            self.tell()


@lie("impulse bystanders tethers conservation", "sticky sticky_grouped", minimal=True, until=90)
class PushedAtABreak(Tether):
    """A tether that breaks changes a velocity by an ulp."""

    def instead(self, sim, hit, pair):
        if hit.kind != "break" or sim.fixed[hit.i] or norm(sim.v[hit.i]) == 0:
            return False
        if sim.forest and sim.forest.body(hit.i):
            return False
        sim.set_velocity(hit.i, off_by(sim.v[hit.i], 1))
        return True
