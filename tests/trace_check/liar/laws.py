"""A scene's rules by pairs of particles, with the phases that are open."""
import math


class Laws:
    def __init__(self, scene):
        self.scene = scene
        self.species = scene["species"]
        self.particles = sorted(scene["particles"], key=lambda p: p["id"])
        self.index = {p["id"]: n for n, p in enumerate(self.particles)}
        self.pairs = {}  # by two particles: the rules, nothing where both are fixed
        self.table = {frozenset(pair["between"]): pair for pair in scene.get("pairs", [])}
        self.open = [False] * len(scene.get("phases", []))
        self.changes = self.known_changes()
        impulses = sorted(scene.get("impulses", []), key=lambda j: (j["at"], j["particle"]))
        self.impulses = [(float(j["at"]), self.index[j["particle"]], tuple(map(float, j["impulse"]))) for j in impulses]

    def known_changes(self):
        """(time, opens, phase): windows close before others open."""
        changes = []
        for n, phase in enumerate(self.scene.get("phases", [])):
            changes.append((float(phase["from"]), True, n))
            if phase["until"] != "inf":
                changes.append((float(phase["until"]), False, n))
        return sorted(changes)

    def mass(self, i):
        return float(self.species[self.particles[i]["species"]]["mass"])

    def capacity(self, i):
        return self.species[self.particles[i]["species"]].get("max_tethers", math.inf)

    def pair(self, i, j):
        if (i, j) not in self.pairs:
            both_fixed = math.isinf(self.mass(i)) and math.isinf(self.mass(j))
            species = frozenset(self.particles[n]["species"] for n in (i, j))
            self.pairs[i, j] = {} if both_fixed else self.table.get(species, {})
        return self.pairs[i, j]

    def blocking(self, i, j):
        return self.pair(i, j).get("blocking")

    def tethering(self, i, j):
        return self.pair(i, j).get("tethering")

    def permanent(self, i, j):
        tethering = self.tethering(i, j)
        return tethering is not None and tethering.get("form", "always") == "permanent"

    def rule(self, i, j, which):
        """The rule "form" or "break" in force."""
        rule = self.tethering(i, j).get(which, "always" if which == "form" else "never")
        between = frozenset(self.pair(i, j)["between"])
        for n, phase in enumerate(self.scene.get("phases", [])):
            if self.open[n] and frozenset(phase["between"]) == between and which in phase:
                rule = phase[which]
        return rule
