"""Lies about the end."""
from lie import ALL, Lie, lie
from numbers_of_traces import after


class Ending(Lie):
    def ending(self, sim, end):
        self.tell()
        return self.instead(sim, end)


@lie("end", ALL, minimal=True)
class EndCountsOneMore(Ending):
    def instead(self, sim, end):
        return {**end, "events": end["events"] + 1}


@lie("end", ALL, minimal=True)
class EndBeforeTheLastEvent(Ending):
    def instead(self, sim, end):
        return {**end, "t": after(sim.last, -1e-3)}


@lie("end", ALL, minimal=True)
class EndBehindTheLastEvent(Ending):
    """By its limit of events a run ends at its last one."""

    def instead(self, sim, end):
        return {**end, "t": after(sim.last, 1e-9)}


@lie("progress end", ALL, minimal=True)
class EndSaysStalled(Ending):
    def instead(self, sim, end):
        return {**end, "end": "stalled"}
