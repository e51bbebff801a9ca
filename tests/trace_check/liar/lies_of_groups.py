"""Lies about bodies: loads, members, restitutions."""

from lie import GROUPED, Lie, lie
from numbers_of_traces import norm, plus, times
from responses import restitution_impulse

class Load(Lie):
    """A load that keeps or moves something else."""

    def loaded(self, sim, hit, v_load, stored):
        if self.now(sim):
            instead = self.instead(sim, hit, v_load, stored)
            if instead and instead != (v_load, stored):
                self.tell()
                return instead
        return v_load, stored


@lie("impulse", GROUPED)
class StoresTheWholeImpulse(Load):
    """Eq. (7) without the momentum that the load has given already."""

    def instead(self, sim, hit, v_load, stored):
        return v_load, hit.dp


@lie("impulse", GROUPED)
class StoresWithParticleMass(Load):
    def instead(self, sim, hit, v_load, stored):
        if (sim.mass[hit.i], sim.mass[hit.j]) == (hit.m_i, hit.m_j):
            return None
        return v_load, restitution_impulse(sim.mass[hit.i], sim.mass[hit.j], sim.v[hit.i], sim.v[hit.j], hit.dp)


@lie("impulse", GROUPED, minimal=True)
class LoadsAtTheMean(Load):
    """(v_A + v_B)/2 whatever the masses."""

    def instead(self, sim, hit, v_load, stored):
        return times(0.5, plus(sim.v[hit.i], sim.v[hit.j])), stored


@lie("impulse conservation", GROUPED)
class LoadOff(Load):
    """By a trillionth."""

    def instead(self, sim, hit, v_load, stored):
        if norm(v_load) < 0.1 * norm(hit.frame.relative):
            return None
        return times(1 + 1e-12, v_load), stored


@lie("groups", GROUPED, minimal=True)
class ExpiryNotRenewed(Lie):
    """A merge keeps the expiry of the elder body."""

    def expiry(self, sim, hit, expiry):
        old = [sim.forest.body(i).expiry for i in (hit.i, hit.j) if sim.forest.body(i)]
        if self.now(sim) and old:
            self.tell()
            return min(old)
        return expiry


@lie("groups", GROUPED, minimal=True)
class MemberLeftBehind(Lie):
    """One member keeps its velocity when its body changes its own."""

    def members(self, sim, record, members):
        if self.now(sim) and len(members) > 2 and "j" in record:
            for m in members:
                if m not in (record["i"], record["j"]):
                    self.tell()
                    return [n for n in members if n != m]
        return members


@lie("groups impulse", "pushed_group", minimal=True, until=60)
class PushOnOneMember(Lie):
    """An impulse on a member moves it alone."""

    def members(self, sim, record, members):
        if self.now(sim) and len(members) > 1 and "j" not in record:
            self.tell()
            return [record["i"]]
        return members


@lie("groups", "gas_grouped chain_grouped", minimal=True, until=60)
class UnwoundInWrongOrder(Lie):
    """Leaves first."""

    def unwinding(self, sim, body, nodes):
        if self.now(sim) and len(nodes) > 1:
            self.tell()
            return nodes[::-1]
        return nodes


@lie("groups schema", "gas_grouped chain_grouped", minimal=True, until=60)
class NodeLeftOut(Lie):
    """One node of a tree is forgotten."""

    def unwinding(self, sim, body, nodes):
        if self.now(sim) and len(nodes) > 1:
            self.tell()
            return nodes[:-1]
        return nodes


@lie("impulse groups", GROUPED, minimal=True)
class RestitutesMore(Lie):
    """A millionth more than was stored."""

    def unwinding(self, sim, body, nodes):
        if self.now(sim) and norm(nodes[0].dp) > 1e-3:
            self.tell()
            nodes[0].dp = times(1 + 1e-6, nodes[0].dp)
        return nodes


@lie("groups impulse", GROUPED, minimal=True)
class NotLoaded(Lie):
    """A grouped scene answers a collision at once."""

    def begin(self, sim):
        def load(hit):
            if self.now(sim) and not (sim.forest.body(hit.i) or sim.forest.body(hit.j)):
                self.tell()
                sim.part(hit)
            else:
                type(sim).load(sim, hit)

        sim.load = load
