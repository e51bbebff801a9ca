"""What happens next in the simulator, and a collision on its way to an answer."""
from responses import Frame
from timing import INNER, OUTER

RESTITUTION, PHASE, IMPULSE, COLLISION = range(4)


class Event:
    def __init__(self, time, rank, i=-1, j=-1, limit=INNER, start=None, root=None):
        self.time, self.rank, self.i, self.j, self.limit = time, rank, i, j, limit
        self.start, self.root = start or time, root  # a time counted from the start, where there is a root
        self.record = {}

    def ties(self):
        return (self.rank, self.i, self.j, self.limit == OUTER)


class Hit:
    """A collision of two bodies on its way from frame to answer."""

    def __init__(self, sim, event):
        self.i, self.j, self.limit = event.i, event.j, event.limit
        self.frame = Frame(sim.place(event.i), sim.place(event.j), sim.v[event.i], sim.v[event.j])
        self.m_i, self.m_j = sim.body_mass(event.i), sim.body_mass(event.j)
        self.dp, self.answered, self.kind, self.record = tuple(0.0 for _ in sim.v[0]), False, "rebound", {}
