"""Lies about order, and about what is known in advance."""
import functools

from lie import CERTIFIED, GROUPED, Lie, lie
from numbers_of_traces import after
from happenings import COLLISION, IMPULSE, PHASE, RESTITUTION, Event


class OutOfOrder(Lie):
    """Takes the second of two events that stand at one time."""

    def __init__(self, first):
        super().__init__(0)

    def chosen(self, sim, event, events):
        if self.now(sim) and len(events) > 1 and events[1].time == event.time and self.is_meant(event, events[1]):
            self.tell()
            return events[1]
        return event

    def is_meant(self, first, second):
        return True


@lie("order earliest", "twins", CERTIFIED)
class TieInWrongOrder(OutOfOrder):
    pass


@lie("order earliest", "near_twins", CERTIFIED)
class NeighboursSwapped(OutOfOrder):
    """Their exact times differ, by less than an ulp."""


@lie("order earliest groups", "tied_group", CERTIFIED)
class CollisionBeforeRestitution(OutOfOrder):
    def is_meant(self, first, second):
        return first.rank == RESTITUTION and second.rank == COLLISION


@lie("order earliest groups", "tied_group", CERTIFIED)
class RestitutionsInWrongOrder(OutOfOrder):
    def is_meant(self, first, second):
        return first.rank == RESTITUTION and second.rank == RESTITUTION


@lie("order earliest", "tied_impulse", CERTIFIED)
class CollisionBeforeImpulse(OutOfOrder):
    def is_meant(self, first, second):
        return first.rank == IMPULSE


class Known(Lie):
    """An event that is known in advance comes late, or not at all."""

    rank, late = RESTITUTION, None

    same = None

    def candidates(self, sim, events):
        events.sort(key=functools.cmp_to_key(sim.order))
        if self.now(sim) and events[0].rank == self.rank and len(events) > 1:
            if self.late is None or sim.now < after(events[0].time, self.late):
                self.same = (events[0].time, events[0].i)
                self.tell()
        if self.same is None:
            return events
        shifted = [] if self.late is None else [self.late]
        others = [e for e in events if not self.is_same(e)]
        return others + [Event(after(e.time, late), e.rank, e.i, e.j) for e in events if self.is_same(e) for late in shifted]

    def is_same(self, e):
        return e.rank == self.rank and (e.time, e.i) == self.same


@lie("groups earliest", GROUPED, minimal=True)
class LateRestitution(Known):
    late = 1e-6


@lie("groups earliest", GROUPED)
class LateRestitutionByLittle(Known):
    late = 1e-13


@lie("groups earliest", GROUPED, minimal=True)
class EarlyRestitution(Known):
    late = -1e-6


@lie("groups earliest end", GROUPED, minimal=True)
class RestitutionPassedOver(Known):
    """For ever: others part meanwhile."""


@lie("groups earliest end", GROUPED, minimal=True)
class RestitutionPassedOverAtTheEnd(Known):
    """The run stops at its limit of events when one more has happened behind the expiry."""

    def stops(self, sim):
        return self.told and self.same[0] < sim.now


@lie("earliest", "sticky sticky_grouped", minimal=True)
class LatePhase(Known):
    rank, late = PHASE, 0.03125


@lie("earliest end", "sticky sticky_grouped", minimal=True, until=60)
class PhasePassedOver(Known):
    rank = PHASE


@lie("earliest", "sticky sticky_grouped", minimal=True)
class LateImpulse(Known):
    rank, late = IMPULSE, 0.03125


@lie("earliest end", "sticky sticky_grouped", minimal=True)
class ImpulseForgotten(Known):
    rank = IMPULSE
