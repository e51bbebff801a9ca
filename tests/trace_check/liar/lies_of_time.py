"""Lies about what happens when: misses, inventions, wrong times, wrong order."""
import functools
import math

from fractions import Fraction

from lie import ALL, CERTIFIED, GROUPED, PLAIN, Hiding, Lie, is_pair, lie, pair_key
from numbers_of_traces import after, dot, elapsed, minus
from responses import collision_impulse
from simulator import COLLISION, IMPULSE, PHASE, RESTITUTION, Event
from timing import INNER, OUTER


class Missing(Hiding):
    """The earliest event of a pair does not happen."""

    limit = None

    def candidates(self, sim, events):
        events = self.without_hidden(sim, events)
        events.sort(key=functools.cmp_to_key(sim.order))
        if self.now(sim) and events and is_pair(events[0], self.limit) and self.is_meant(sim, events):
            self.hide(sim, events[0])
            return events[1:]
        return events

    def is_meant(self, sim, events):
        return len(events) > 1


@lie("earliest bounds", ALL, minimal=True)
class MissedHit(Missing):
    limit = INNER


@lie("earliest bounds", PLAIN, minimal=True)
class MissedPull(Missing):
    limit = OUTER


@lie("earliest bounds", "graze", minimal=True)
class MissedGraze(Missing):
    def __init__(self, first):
        super().__init__(0)

    def is_meant(self, sim, events):
        return events[0].i == 0


@lie("earliest bounds", "exact_graze", CERTIFIED)
class MissedExactGraze(MissedGraze):
    pass


@lie("earliest bounds", "crossing", minimal=True)
class MissedCrossing(Missing):
    """Of two fast motes; their neighbours are slow."""

    def __init__(self, first):
        super().__init__(0)

    def is_meant(self, sim, events):
        return sim.mass[events[0].i] < 1


@lie("end earliest bounds", "gas chain gas_grouped", minimal=True)
class MissedAtMaxEvents(Missing):
    """The run stops at its limit of events just behind the miss."""

    def stops(self, sim):
        return self.told and sim.k > self.k

    def hide(self, sim, event):
        self.k = sim.k
        super().hide(sim, event)


@lie("end earliest bounds", "graze twins crossing", minimal=True)
class MissedLast(Missing):
    """The last event of all; the run ends by its duration."""

    def __init__(self, first):
        super().__init__(0)

    def is_meant(self, sim, events):
        return all(e.time[0] > float(sim.scene["duration"]) for e in events[1:])


@lie("end earliest bounds", "crossing", minimal=True)
class MissedForEver(Missing):
    """The last event of all; the run says that there are no more."""

    def __init__(self, first):
        super().__init__(0)

    def is_meant(self, sim, events):
        return len(events) == 1


@lie("end earliest", "gas chain sticky", minimal=True)
class EndsBeforeItIsDue(Lie):
    """Stops at the duration though events are due before it."""

    def candidates(self, sim, events):
        if self.now(sim):
            self.tell()
        return [] if self.told else events

    def ending(self, sim, end):
        return {**end, "end": "duration", "t": (float(sim.scene["duration"]), 0.0)}


@lie("end earliest", "gas chain", minimal=True)
class NoMoreThoughMore(EndsBeforeItIsDue):
    def ending(self, sim, end):
        return {**end, "end": "no_more_events", "t": sim.now}


@lie("contact", ALL, minimal=True)
class InventedHit(Lie):
    """A pair that is nowhere near its limit."""

    def candidates(self, sim, events):
        if self.now(sim):
            next_time = min(e.time for e in events)
            here = after(sim.now, elapsed(sim.now, next_time) / 2)
            for i in range(sim.n):
                for j in range(i + 1, sim.n):
                    law = sim.laws.blocking(i, j)
                    if not law or (sim.forest and sim.forest.together(i, j)):
                        continue
                    r = minus(sim.place_at(j, here), sim.place_at(i, here))
                    if math.sqrt(dot(r, r)) > 1.5 * law["distance"] and dot(r, minus(sim.v[j], sim.v[i])) < 0:
                        self.tell()
                        return events + [Event(here, COLLISION, i, j, INNER)]
        return events


@lie("contact", "graze", minimal=True)
class InventedGraze(Lie):
    """A pair that misses by a millionth of its limit rebounds where it is nearest."""

    def __init__(self, first):
        super().__init__(0)

    def begin(self, sim):
        x, y = sim.x[1]
        sim.scene["particles"][1]["position"] = [x, 1 + 1e-6]
        sim.x[1] = (x, 1 + 1e-6)

    def candidates(self, sim, events):
        if self.now(sim):
            self.tell()
            events.append(Event((-sim.x[1][0] - 1e-6, 0.0), COLLISION, 0, 1, INNER))
        return events


class Shifted(Lie):
    """An event of a pair at another time, before everything else that is due."""

    part = 0.0  # of the pair's limit over its speed along its axis

    def shift(self, sim, event, events):
        r = minus(sim.place_at(event.j, event.time), sim.place_at(event.i, event.time))
        v = minus(sim.v[event.j], sim.v[event.i])
        speed = abs(dot(r, v)) / math.sqrt(dot(r, r))
        return self.part / speed if speed > 0.3 * math.sqrt(dot(v, v)) else None

    def chosen(self, sim, event, events):
        if not self.now(sim) or not is_pair(event):
            return event
        shift = self.shift(sim, event, events)
        if not shift:
            return event
        time = after(event.time, shift)
        between = sim.now < time and (len(events) == 1 or time < events[1].time)
        if not between or time == event.time:
            return event
        self.tell()
        return Event(time, event.rank, event.i, event.j, event.limit)


@lie("contact", ALL, minimal=True)
class LateByABillionth(Shifted):
    part = 1e-9


@lie("contact", ALL)
class LateByATenTrillionth(Shifted):
    part = 1e-13


@lie("contact", ALL, minimal=True)
class EarlyByABillionth(Shifted):
    part = -1e-9


@lie("contact", ALL)
class EarlyByATenTrillionth(Shifted):
    part = -1e-13


@lie("contact", PLAIN + " sticky", CERTIFIED)
class LateByAnUlp(Shifted):
    sign = 1

    def shift(self, sim, event, events):
        t = event.root.rounded()
        return self.sign * math.ulp(t) if t > 0 else None


@lie("contact", PLAIN + " sticky", CERTIFIED)
class EarlyByAnUlp(LateByAnUlp):
    sign = -1


@lie("contact", PLAIN + " gas_grouped", minimal=True)
class WrongPair(Lie):
    """The pair that is next but one, at the time of the next."""

    def chosen(self, sim, event, events):
        if self.now(sim) and is_pair(event):
            for other in events[1:]:
                if is_pair(other) and not {other.i, other.j} & {event.i, event.j} and elapsed(event.time, other.time) > 1e-3:
                    self.tell()
                    return Event(event.time, COLLISION, other.i, other.j, other.limit)
        return event


@lie("contact", PLAIN + " gas_grouped", minimal=True)
class WrongPartner(Lie):
    def chosen(self, sim, event, events):
        if self.now(sim) and is_pair(event, INNER):
            for j in range(sim.n):
                if j not in (event.i, event.j) and sim.laws.blocking(event.i, j) and not (sim.forest and sim.forest.together(event.i, j)):
                    self.tell()
                    return Event(event.time, COLLISION, *sorted((event.i, j)), INNER)
        return event


class Unsigned(Lie):
    """Takes eq. (4) whatever the sign of v_n."""

    pair = None

    def impulse(self, sim, hit):
        if self.told and (hit.i, hit.j) == self.pair:
            c = sim.laws.blocking(hit.i, hit.j)["c_rebound"]
            hit.dp, hit.answered = collision_impulse(hit.frame, hit.m_i, hit.m_j, c), True
            self.pair = None


@lie("earliest contact bounds", PLAIN, minimal=True)
class LargerRoot(Unsigned):
    """The pair flies through itself and rebounds where it leaves the limit."""

    seen = None

    def candidates(self, sim, events):
        events.sort(key=functools.cmp_to_key(sim.order))
        first = events[0]
        if self.now(sim) and is_pair(first, INNER):
            moved = [sim.place_at(k, first.time) for k in (first.i, first.j)]
            r, v = minus(moved[1], moved[0]), minus(sim.v[first.j], sim.v[first.i])
            self.pair = (first.i, first.j)
            self.event = Event(after(first.time, -2 * dot(r, v) / dot(v, v)), COLLISION, first.i, first.j, INNER)
            self.seen = (sim.v[first.i], sim.v[first.j])
            self.tell()
        if self.pair and (sim.v[self.pair[0]], sim.v[self.pair[1]]) == self.seen:
            return [e for e in events if not (is_pair(e) and (e.i, e.j) == self.pair)] + [self.event]
        return events


@lie("contact", "gas chain sticky", minimal=True)
class NoApproachTest(Unsigned):
    """The pair that has just rebounded has a root 0."""

    before = None

    def candidates(self, sim, events):
        if self.now(sim) and self.before:
            i, j = self.pair = self.before
            self.tell()
            return events + [Event(sim.now, COLLISION, i, j, INNER)]
        return events

    def tether(self, sim, hit):
        self.before = (hit.i, hit.j) if hit.limit == INNER else None


@lie("contact", PLAIN, minimal=True)
class StalePrediction(Lie):
    """A third particle's event with a partner that has changed since comes as it was predicted."""

    known, stale = (), None

    def candidates(self, sim, events):
        present = {(pair_key(e), e.time) for e in events}
        if self.now(sim) and sim.k > self.first:
            following = min(e.time for e in events)
            for old in self.known:
                changed = sum(sim.clock[k] == sim.now for k in (old.i, old.j))
                if changed == 1 and (pair_key(old), old.time) not in present and sim.now < old.time < following:
                    self.tell()
                    return events + [Event(old.time, COLLISION, old.i, old.j, old.limit)]
        self.known = [e for e in events if is_pair(e, INNER)]
        return events


@lie("earliest bounds", PLAIN + " gas_grouped", minimal=True)
class NotPredictedAgain(Hiding):
    """After an event the pairs of one of its particles with a third one are forgotten."""

    known = ()

    def candidates(self, sim, events):
        events = self.without_hidden(sim, events)
        if self.now(sim):
            first = min(events, key=functools.cmp_to_key(sim.order))
            new = is_pair(first) and pair_key(first) not in self.known and len(events) > 1
            changed = sum(sim.clock[k] == sim.now for k in (first.i, first.j)) if new else 0
            if changed == 1:
                self.hide(sim, first)
                return self.without_hidden(sim, events)
        self.known = {pair_key(e) for e in events if is_pair(e)}
        return events


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
