"""Lies about what happens when: inventions, wrong times, wrong pairs."""
import functools
import math

from lie import ALL, CERTIFIED, PLAIN, Hiding, Lie, is_pair, lie, pair_key
from numbers_of_traces import after, dot, elapsed, minus
from responses import collision_impulse
from happenings import COLLISION, Event
from timing import INNER


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
