"""Lies that leave an event out, or end before it."""
import functools

from lie import ALL, CERTIFIED, PLAIN, Hiding, Lie, is_pair, lie
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
