"""Trees of loads: bodies that move as one until they restitute (semantics §4)."""
import math


class Node:
    """A load: its pair, the two sides (a node, a particle, or None for an infinite mass), Δp_AB."""

    def __init__(self, i, j, limit, sides, masses, dp):
        self.i, self.j, self.limit, self.sides, self.masses, self.dp = i, j, limit, sides, masses, dp


class Body:
    def __init__(self, members, mass, expiry, birth, root):
        self.members, self.mass, self.expiry, self.birth, self.root = members, mass, expiry, birth, root


def leaves(side):
    """The particles below a side."""
    if side is None:
        return []
    if isinstance(side, Node):
        return sorted(leaves(side.sides[0]) + leaves(side.sides[1]))
    return [side]


def preorder(node):
    """Root first."""
    yield node
    for side in node.sides:
        if isinstance(side, Node):
            yield from preorder(side)


class Forest:
    def __init__(self):
        self.of = {}

    def body(self, i):
        return self.of.get(i)

    def bodies(self):
        return sorted({id(b): b for b in self.of.values()}.values(), key=lambda b: b.members[0])

    def together(self, i, j):
        return self.of.get(i) is not None and self.of.get(i) is self.of.get(j)

    def members(self, i):
        return self.of[i].members if i in self.of else [i]

    def side(self, i, fixed):
        return None if fixed else (self.of[i].root if i in self.of else i)

    def join(self, node, fixed, expiry, now):
        members, birth = [], now
        for n, particle in enumerate((node.i, node.j)):
            if fixed[n]:
                continue
            members += self.members(particle)
            if particle in self.of and self.of[particle].birth < birth:
                birth = self.of[particle].birth
        body = Body(sorted(members), node.masses[0] + node.masses[1], expiry, birth, node)
        for m in body.members:
            self.of[m] = body
        return body

    def dissolve(self, body):
        for m in body.members:
            del self.of[m]


def group_data(body, names, text, texts):
    """A body as a full state has it; node 0 is the root."""
    nodes = list(preorder(body.root))
    number = {id(n): k for k, n in enumerate(nodes)}

    def side(s):
        if s is None:
            return None
        return {"node": number[id(s)]} if isinstance(s, Node) else {"particle": names[s]}

    return {
        "members": [names[m] for m in body.members],
        "mass": text(body.mass) if not math.isinf(body.mass) else "inf",
        "expiry": texts(body.expiry),
        "birth": texts(body.birth),
        "nodes": [{"i": names[n.i], "j": names[n.j], "limit": n.limit, "sides": [side(s) for s in n.sides],
                   "masses": [text(m) for m in n.masses], "dp": texts(n.dp)} for n in nodes],
    }
