"""What comes next in the simulator: every pair is asked, and the first event taken."""
import functools
import math

from happenings import COLLISION, IMPULSE, PHASE, RESTITUTION, Event
from numbers_of_traces import after, exact
from timing import INNER, OUTER, compare, exact_root, stable_time


class Schedule:
    """The part of Simulator that asks."""

    def ask(self, i, j, limit, length, only_hit):
        """The pair's next event at one limit, by the two stored states alone."""
        start = max(self.clock[i], self.clock[j])
        key = (i, j, limit, only_hit)
        seen = (self.x[i], self.x[j], self.v[i], self.v[j], self.clock[i], self.clock[j])
        if self.asked.get(key, (None,))[0] == seen:
            return self.asked[key][1]
        states = self.place_at(i, start), self.place_at(j, start), self.v[i], self.v[j]
        event = None
        if self.timing == "certified":
            root = exact_root(*states, length, limit, only_hit)
            if root:
                event = Event(after(start, root.rounded()), COLLISION, i, j, limit, start, root)
        else:
            t = stable_time(*states, length, limit, only_hit)
            if t is not None:
                event = Event(after(start, t), COLLISION, i, j, limit)
        self.asked[key] = (seen, event)
        return event

    def pair_events(self, i, j):
        if (self.forest and self.forest.together(i, j)) or math.isinf(min(self.body_mass(i), self.body_mass(j))):
            return
        blocking, tethering = self.laws.blocking(i, j), self.laws.tethering(i, j)
        if blocking and not self.has_responded(i, j, INNER):
            yield self.ask(i, j, INNER, float(blocking["distance"]), False)
        if tethering and self.tethered(i, j):
            yield self.ask(i, j, OUTER, float(tethering["distance"]), self.has_responded(i, j, OUTER))

    def all_events(self):
        events = [e for i in range(self.n) for j in range(i + 1, self.n) for e in self.pair_events(i, j) if e]
        for body in self.forest.bodies() if self.forest else []:
            events.append(Event(body.expiry, RESTITUTION, body.members[0], body.members[0]))
        if self.phases_done < len(self.laws.changes):
            events.append(Event((self.laws.changes[self.phases_done][0], 0.0), PHASE))
        if self.impulses_done < len(self.laws.impulses):
            events.append(Event((self.laws.impulses[self.impulses_done][0], 0.0), IMPULSE))
        return events

    def order(self, a, b):
        """Negative where a comes before b."""
        if self.timing == "certified":
            apart = abs(a.time[0] - b.time[0])
            if apart <= 2.0**-40 * max(abs(a.time[0]), abs(b.time[0])):
                exactly = compare(exact(a.start), a.root, exact(b.start), b.root)
                return exactly or (-1 if a.ties() < b.ties() else a.ties() > b.ties())
        key_a, key_b = (a.time, a.ties()), (b.time, b.ties())
        return -1 if key_a < key_b else key_a > key_b

    def next_event(self):
        events = self.lie.candidates(self, self.all_events())
        if not events:
            return None
        events.sort(key=functools.cmp_to_key(self.order))
        return self.lie.chosen(self, events[0], events)
