"""Lies about bystanders, what is written down, and full states."""
import copy
import math

from lie import ALL, GROUPED, PLAIN, Lie, lie
from numbers_of_traces import after, hexadecimal, minus, next_after, norm, off_by, times
from timing import INNER


class Bystander(Lie):
    """Something happens to a particle that has no part in an event."""

    def recorded(self, sim, record):
        if self.now(sim):
            for m in range(sim.n):
                free = not sim.fixed[m] and not (sim.forest and sim.forest.body(m))
                if free and m not in record["involved"] and norm(sim.v[m]) > 0.01:
                    self.tell()
                    self.happens(sim, m)
                    break
        return record


@lie("bystanders states", ALL, until=40)
class BystanderTurned(Bystander):
    """Its velocity changes by an ulp."""

    def happens(self, sim, m):
        sim.v[m] = off_by(sim.v[m], 1)


@lie("flight states", ALL, until=40)
class BystanderMoved(Bystander):
    """Its position jumps by eight ulps of the coordinates of the scene."""

    def happens(self, sim, m):
        k = max(range(len(sim.x[m])), key=lambda n: abs(sim.x[m][n]))
        jump = 8 * math.ulp(abs(sim.x[m][k]) + 4)
        sim.x[m] = tuple(x + jump if n == k else x for n, x in enumerate(sim.x[m]))


@lie("bystanders flight", ALL)
class InfiniteMassMoved(Lie):
    """A wall recoils."""

    def recorded(self, sim, record):
        if self.now(sim) and "j" in record and record["kind"] != "restitute":
            for m in (record["i"], record["j"]):
                if sim.fixed[m]:
                    self.tell()
                    sim.v[m] = tuple(x + 1e-9 for x in sim.v[m])
                    record["post"][m] = (record["post"][m][0], sim.v[m])
        return record


@lie("flight", ALL)
class Jump(Lie):
    """A particle arrives eight ulps beside its path."""

    def brought(self, sim, i, x):
        if self.now(sim) and sim.clock[i] < sim.now:
            v = max(abs(a) for a in minus(x, sim.x[i]))
            k = max(range(len(x)), key=lambda n: abs(x[n]))
            size = math.ulp(max(abs(x[k]), v))
            self.tell()
            return tuple(a + 8 * size if n == k else a for n, a in enumerate(x))
        return x


class Written(Lie):
    """The record is changed, the simulation is not."""

    minimal_too = False

    def recorded(self, sim, record):
        if self.now(sim) and self.is_meant(record):
            record = copy.copy(record)
            self.tell()
            self.rewrite(sim, record)
        return record

    def is_meant(self, record):
        return True


@lie("order", ALL)
class DtOff(Written):
    def is_meant(self, record):
        return record["dt"] > 1e-6

    def rewrite(self, sim, record):
        record["dt"] = next_after(record["dt"], 2)


@lie("order", ALL)
class CountSkips(Written):
    def rewrite(self, sim, record):
        record["k"] = sim.k = sim.k + 1


@lie("order", PLAIN + " sticky", minimal=True)
class TimeGoesBack(Written):
    def rewrite(self, sim, record):
        record["t"] = after(sim.last, -1e-3)


@lie("impulse", "gas chain")
class OtherDp(Written):
    """The Δp that is written down is not the one that acted."""

    def is_meant(self, record):
        return record["kind"] in ("rebound", "retract") and norm(record["dp"]) > 0

    def rewrite(self, sim, record):
        record["dp"] = times(1 + 1e-12, record["dp"])


@lie("impulse contact tethers", "gas chain", minimal=True)
class OtherKind(Written):
    def is_meant(self, record):
        return record["kind"] in ("retract", "rebound") and norm(record.get("dp", (0,))) > 1e-3

    def rewrite(self, sim, record):
        record["kind"] = {"retract": "rebound", "rebound": "retract"}[record["kind"]]


@lie("bystanders", ALL)
class OtherArrival(Written):
    """A particle is said to arrive with another velocity."""

    def is_meant(self, record):
        return "j" in record and norm(record["pre"][record["j"]][1]) > 0

    def rewrite(self, sim, record):
        x, v = record["pre"][record["j"]]
        record["pre"] = {**record["pre"], record["j"]: (x, off_by(v, 1))}


@lie("states flight bystanders", ALL)
class OtherStart(Lie):
    """The run starts with another velocity than its scene."""

    def __init__(self, first):
        super().__init__(0)

    def begin(self, sim):
        m = next(i for i in range(sim.n) if not sim.fixed[i] and norm(sim.v[i]) > 0)
        sim.v[m] = off_by(sim.v[m], 1)
        self.tell()


@lie("earliest schema order tethers groups impulse contact", "sticky sticky_grouped", minimal=True)
class ImpulseTwice(Lie):
    def begin(self, sim):
        self.once = [copy.copy(j) for j in sim.laws.impulses]

    def pushed(self, sim, particle, impulse):
        if self.now(sim):
            self.tell()
            sim.laws.impulses.insert(sim.impulses_done, (sim.now[0], particle, impulse))
        return particle, impulse


@lie("earliest impulse schema bystanders groups", "sticky sticky_grouped", minimal=True)
class ImpulseOnAnother(Lie):
    def pushed(self, sim, particle, impulse):
        if self.now(sim):
            self.tell()
            return particle % (sim.n - 1) + 1, impulse
        return particle, impulse


@lie("earliest impulse", "sticky sticky_grouped", minimal=True)
class ImpulseTooStrong(Lie):
    def pushed(self, sim, particle, impulse):
        if self.now(sim):
            self.tell()
            return particle, times(1 + 1e-9, impulse)
        return particle, impulse


class State(Lie):
    """A full state that is not what the events made."""

    def state(self, sim, state):
        if self.now(sim) and sim.k and self.rewrite(sim, state):
            self.tell()
        return state


@lie("states", ALL)
class StateOtherVelocity(State):
    def rewrite(self, sim, state):
        p = next(p for p in state["particles"] if not sim.fixed[sim.ids.index(p["id"])])
        v = sim.v[sim.ids.index(p["id"])]
        p["velocity"] = [hexadecimal(x) for x in off_by(v, 1)]
        return norm(v) > 0


@lie("states", ALL)
class StateOtherPosition(State):
    def rewrite(self, sim, state):
        p = state["particles"][-1]
        p["position"] = [hexadecimal(x) for x in off_by(sim.x[sim.ids.index(p["id"])], 1)]
        return True


@lie("states", ALL)
class StateOtherClock(State):
    def rewrite(self, sim, state):
        p = next(p for p in state["particles"] if not sim.fixed[sim.ids.index(p["id"])])
        p["clock"] = [hexadecimal(x) for x in after(sim.clock[sim.ids.index(p["id"])], 2.0**-40)]
        return True


@lie("states", "chain chain_grouped")
class StateWithoutATether(State):
    def rewrite(self, sim, state):
        return state["tethers"].pop() is not None


@lie("states", PLAIN + " sticky")
class StateWithoutAResponse(State):
    def rewrite(self, sim, state):
        return bool(state["responded"]) and state["responded"].pop() is not None


@lie("states", PLAIN + " sticky")
class StateWithAnotherResponse(State):
    def rewrite(self, sim, state):
        others = [[sim.ids[i], sim.ids[j], "inner"] for i in range(sim.n) for j in range(i + 1, sim.n)
                  if sim.laws.blocking(i, j) and not sim.has_responded(i, j, INNER)]
        state["responded"].append(others[0])
        return True


@lie("states", GROUPED)
class StateOtherStoredImpulse(State):
    def rewrite(self, sim, state):
        if not state["groups"]:
            return False
        node, body = state["groups"][0]["nodes"][0], sim.forest.bodies()[0]
        node["dp"] = [hexadecimal(x) for x in off_by(body.root.dp, 1)]
        return True


@lie("states", GROUPED)
class StateOtherExpiry(State):
    def rewrite(self, sim, state):
        if not state["groups"]:
            return False
        state["groups"][0]["expiry"] = [hexadecimal(x) for x in after(sim.forest.bodies()[0].expiry, 1e-6)]
        return True


@lie("states", GROUPED)
class StateWithoutAGroup(State):
    def rewrite(self, sim, state):
        return bool(state["groups"]) and state["groups"].pop() is not None


@lie("states", "lottery lottery_grouped")
class StateOtherDraws(State):
    def rewrite(self, sim, state):
        if not state["draws"]:
            return False
        state["draws"][0][-1] += 1
        return True


@lie("states", ALL)
class StateOtherCounts(State):
    def rewrite(self, sim, state):
        kind = next(iter(state["counts"]))
        state["counts"][kind] += 1
        return True


@lie("states", "sticky sticky_grouped")
class StateOtherProgress(State):
    def rewrite(self, sim, state):
        if not state["progress"]:
            return False
        state["progress"][next(iter(state["progress"]))] += 1
        return True
