"""What all lies have in common: when they are told, and which rule of `tps check` has to catch them."""
from happenings import COLLISION
from honesty import Honesty

LIES = {}


def lie(rules, scenes, timings=("certified", "stable"), minimal=False, until=30):
    """Registers a lie. `rules`: one of these has to be violated. `minimal`: it shows in a minimal trace, too."""

    def register(kind):
        name = "".join("_" + c.lower() if c.isupper() else c for c in kind.__name__).lstrip("_")
        kind.name, kind.rules, kind.scenes = name, set(rules.split()), scenes.split()
        kind.timings, kind.minimal, kind.until = timings, minimal, until
        LIES[name] = kind
        return kind

    return register


CERTIFIED = ("certified",)
STABLE = ("stable",)
PLAIN = "gas chain"
GROUPED = "gas_grouped chain_grouped sticky_grouped"
ALL = "gas chain gas_grouped chain_grouped sticky sticky_grouped"


class Lie(Honesty):
    """Honest up to event number `first`; then it lies once, where it can, and says so in `told`."""

    def __init__(self, first):
        self.first, self.told = first, 0

    def now(self, sim):
        return not self.told and sim.k >= self.first

    def tell(self):
        self.told = 1
        return True


def is_pair(event, limit=None):
    return event.rank == COLLISION and limit in (None, event.limit)


def pair_key(event):
    return (event.i, event.j, event.limit)


def velocities(sim, i, j):
    return sim.v[i], sim.v[j], sim.clock[i], sim.clock[j]


class Hiding(Lie):
    """Hides one pair's events until one of the two changes."""

    hidden = None

    def is_hidden(self, sim, event):
        return (self.hidden is not None and is_pair(event) and (event.i, event.j) == self.hidden[0]
                and velocities(sim, event.i, event.j) == self.hidden[1])

    def hide(self, sim, event):
        self.hidden = ((event.i, event.j), velocities(sim, event.i, event.j))
        self.tell()

    def without_hidden(self, sim, events):
        return [e for e in events if not self.is_hidden(sim, e)]
