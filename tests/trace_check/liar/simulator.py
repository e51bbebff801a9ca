"""A small event-driven simulator of its own, honest unless a lie is put into it (lies.py).

All pairs are asked at every step; nothing is fast, nothing is shared with reference/. A lie overrides one of the
hooks of Honesty, once; the simulation goes on from whatever it did.
"""
import functools
import math

from groups import Forest, Node, leaves, preorder
from laws import Laws
from numbers_of_traces import after, elapsed, exact, norm, plus
from philox import TETHER_BREAK, TETHER_FORM, uniform
from responses import (Frame, apply_impulse, collision_impulse, load_velocity, restitution_impulse, retraction_suffices, revolution_impulse)
from timing import INNER, OUTER, compare, exact_root, stable_time
from trace_text import Writer

RESTITUTION, PHASE, IMPULSE, COLLISION = range(4)


class Honesty:
    """What a lie may change. Every hook says the truth here."""

    def begin(self, sim): pass
    def stops(self, sim): return False
    def candidates(self, sim, events): return events
    def chosen(self, sim, event, events): return event
    def brought(self, sim, i, x): return x
    def impulse(self, sim, hit): pass
    def tether(self, sim, hit): pass
    def applied(self, sim, hit, velocities): return velocities
    def loaded(self, sim, hit, v_load, dp_stored): return v_load, dp_stored
    def expiry(self, sim, hit, expiry): return expiry
    def members(self, sim, record, members): return members
    def unwinding(self, sim, body, nodes): return nodes
    def pushed(self, sim, particle, impulse): return particle, impulse
    def phase(self, sim, opens, phase): return opens
    def recorded(self, sim, record): return record
    def state(self, sim, state): return state
    def ending(self, sim, end): return end


class Event:
    def __init__(self, time, rank, i=-1, j=-1, limit=INNER, start=None, root=None):
        self.time, self.rank, self.i, self.j, self.limit = time, rank, i, j, limit
        self.start, self.root = start if start is not None else exact(time), root
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


class Simulator:
    def __init__(self, scene, timing="certified", state_every=7, lie=None):
        self.laws, self.timing, self.lie = Laws(scene), timing, lie or Honesty()
        self.scene, self.n = scene, len(scene["particles"])
        self.mass = [self.laws.mass(i) for i in range(self.n)]
        self.fixed = [math.isinf(m) for m in self.mass]
        self.x = [tuple(map(float, p["position"])) for p in self.laws.particles]
        self.v = [tuple(map(float, p.get("velocity", [0.0] * scene["dimension"]))) for p in self.laws.particles]
        self.clock = [(0.0, 0.0)] * self.n
        self.ids = [p["id"] for p in self.laws.particles]
        self.tethers = {tuple(sorted(self.laws.index[i] for i in pair)) for pair in scene.get("tethers", [])}
        self.responded = [set() for _ in range(self.n)]
        self.forest = Forest() if "grouping" in scene else None
        self.now = self.last = (0.0, 0.0)
        self.k = self.progress = self.phases_done = self.impulses_done = 0
        self.draws, self.kinds, self.asked = {}, {}, {}
        self.out = Writer(scene, timing, state_every)
        self.state_every = state_every
        self.lie.begin(self)

    # Particles

    def place_at(self, i, t):
        return self.x[i] if self.clock[i] == t else plus(self.x[i], self.v[i], elapsed(self.clock[i], t))

    def place(self, i):
        return self.place_at(i, self.now)

    def bring(self, i):
        if not self.fixed[i]:
            self.x[i], self.clock[i] = self.lie.brought(self, i, self.place(i)), self.now

    def set_velocity(self, i, v):
        if not self.fixed[i]:
            if v != self.v[i]:
                self.responded[i].clear()
            self.v[i] = v

    def respond_noted(self, i, j, limit):
        for a, b in ((i, j), (j, i)):
            if not self.fixed[a]:
                self.responded[a].add((b, limit))

    def has_responded(self, i, j, limit):
        return all(self.fixed[a] or (b, limit) in self.responded[a] for a, b in ((i, j), (j, i)))

    def body_mass(self, i):
        body = self.forest.body(i) if self.forest else None
        return body.mass if body else self.mass[i]

    def members(self, i):
        if self.fixed[i]:
            return []
        return self.forest.members(i) if self.forest else [i]

    def tethered(self, i, j):
        return self.laws.tethering(i, j) is not None and (self.laws.permanent(i, j) or (i, j) in self.tethers)

    # What comes next

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
                event = Event(after(start, root.rounded()), COLLISION, i, j, limit, exact(start), root)
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
                exactly = compare(a.start, a.root, b.start, b.root)
                return exactly or (-1 if a.ties() < b.ties() else a.ties() > b.ties())
        key_a, key_b = (a.time, a.ties()), (b.time, b.ties())
        return -1 if key_a < key_b else key_a > key_b

    def next_event(self):
        events = self.lie.candidates(self, self.all_events())
        if not events:
            return None
        events.sort(key=functools.cmp_to_key(self.order))
        return self.lie.chosen(self, events[0], events)

    # What happens

    def step(self, event):
        self.now = max(event.time, self.now)
        before = self.k
        if event.rank == RESTITUTION:
            self.restitute(self.forest.body(event.i))
        elif event.rank == PHASE:
            self.change_phase()
        elif event.rank == IMPULSE:
            self.push()
        else:
            self.collide(event)
        if before // self.state_every != self.k // self.state_every:
            self.write_state()

    def open_record(self, kind, involved):
        for i in involved:
            self.bring(i)
        record = {"kind": kind, "involved": list(involved)}
        if involved:
            record["i"] = involved[0]
            record["pre"] = {i: (self.place(i), self.v[i]) for i in involved}
        return record

    def close_record(self, record):
        record["post"] = {i: (record["pre"][i][0], self.v[i]) for i in record["involved"]}
        self.k += 1
        record.update(k=self.k, t=self.now, dt=elapsed(self.last, self.now))
        if self.now[0] != self.last[0]:
            self.progress = self.k - 1  # events before the clock moved
        record = self.lie.recorded(self, record)
        self.last = self.now
        for one in record if isinstance(record, list) else [record]:
            self.kinds[one["kind"]] = self.kinds.get(one["kind"], 0) + 1
            self.out.event(self, one)

    def collide(self, event):
        record = self.open_record("rebound", [event.i, event.j])
        hit = Hit(self, event)
        hit.record = {**record, "j": event.j}
        self.answer_inner(hit) if event.limit == INNER else self.answer_outer(hit)
        self.lie.impulse(self, hit)
        self.change_tether(hit)
        self.lie.tether(self, hit)
        hit.record["kind"] = hit.kind
        if hit.kind != "break":
            hit.record["dp"] = hit.dp
            if hit.answered:
                self.load(hit) if self.forest else self.part(hit)
            if not (self.forest and self.forest.together(hit.i, hit.j)):
                self.respond_noted(hit.i, hit.j, hit.limit)
        self.close_record(hit.record)

    def answer_inner(self, hit):
        if hit.frame.normal < 0:
            c = float(self.laws.blocking(hit.i, hit.j)["c_rebound"])
            hit.dp, hit.answered = collision_impulse(hit.frame, hit.m_i, hit.m_j, c), True

    def answer_outer(self, hit):
        law = self.laws.tethering(hit.i, hit.j)
        retract, revolve, theta = (float(law[k]) for k in ("c_retract", "c_revolve", "theta_revolve_deg"))
        hit.kind = "retract"
        if hit.frame.normal < 0 and norm(hit.frame.across) == 0:
            return
        hit.answered = True
        if hit.frame.normal >= 0 and retraction_suffices(hit.frame, retract, theta):
            hit.dp = collision_impulse(hit.frame, hit.m_i, hit.m_j, retract)
        else:
            hit.kind = "revolve"
            hit.dp = revolution_impulse(hit.frame, hit.m_i, hit.m_j, revolve, theta)

    def draw(self, purpose, i, j):
        used = self.draws.get((purpose, self.ids[i], self.ids[j]), 0)
        self.draws[purpose, self.ids[i], self.ids[j]] = used + 1
        return uniform(int(self.scene.get("seed", 0)), purpose, self.ids[i], self.ids[j], used)

    def is_full(self, i):
        return sum(i in pair for pair in self.tethers) >= self.laws.capacity(i)

    def decides(self, rule, purpose, hit):
        if rule in ("never", "always"):
            return rule == "always"
        if "impulse_above" in rule:
            return math.sqrt(sum(p * p for p in hit.dp)) > rule["impulse_above"]
        hit.record["draw"] = self.draw(purpose, hit.i, hit.j)
        return hit.record["draw"] < rule["probability"]

    def change_tether(self, hit):
        law, pair = self.laws.tethering(hit.i, hit.j), (hit.i, hit.j)
        if not law:
            return
        if hit.limit == OUTER:
            if not self.laws.permanent(*pair) and self.decides(self.laws.rule(*pair, "break"), TETHER_BREAK, hit):
                self.tethers.discard(pair)
                hit.kind, hit.record["tether"] = "break", "broken"
        elif not self.laws.permanent(*pair) and pair not in self.tethers and not any(map(self.is_full, pair)):
            if self.decides(self.laws.rule(*pair, "form"), TETHER_FORM, hit):
                self.tethers.add(pair)
                hit.record["tether"] = "formed"

    def part(self, hit):
        new = apply_impulse(hit.m_i, hit.m_j, self.v[hit.i], self.v[hit.j], hit.dp)
        for i, v in zip((hit.i, hit.j), self.lie.applied(self, hit, new)):
            self.set_velocity(i, v)

    def load(self, hit):
        v_load = load_velocity(hit.m_i, hit.m_j, self.v[hit.i], self.v[hit.j])
        stored = restitution_impulse(hit.m_i, hit.m_j, self.v[hit.i], self.v[hit.j], hit.dp)
        v_load, stored = self.lie.loaded(self, hit, v_load, stored)
        fixed = self.fixed[hit.i], self.fixed[hit.j]
        sides = [self.forest.side(i, f) for i, f in zip((hit.i, hit.j), fixed)]
        node = Node(hit.i, hit.j, hit.limit, sides, (hit.m_i, hit.m_j), stored)
        expiry = self.lie.expiry(self, hit, after(self.now, float(self.scene["grouping"]["dt_restitute"])))
        body = self.forest.join(node, fixed, expiry, self.now)
        self.move_as_one(hit.record, body.members, v_load)
        hit.record["dp_stored"], hit.record["members"] = stored, list(body.members)

    def move_as_one(self, record, members, v):
        for m in members:
            if m not in record["involved"]:
                self.bring(m)
                record["pre"][m] = (self.place(m), self.v[m])
                record["involved"].append(m)
        for m in self.lie.members(self, record, members):
            self.set_velocity(m, v)

    def restitute(self, body):
        self.forest.dissolve(body)
        for m in body.members:
            self.bring(m)
        for node in self.lie.unwinding(self, body, list(preorder(body.root))):
            record = {**self.open_record("restitute", [node.i, node.j]), "j": node.j, "dp": node.dp}
            v_i, v_j = apply_impulse(*node.masses, self.v[node.i], self.v[node.j], node.dp)
            for side, v in zip(node.sides, (v_i, v_j)):
                for m in leaves(side):
                    self.set_velocity(m, v)
            self.respond_noted(node.i, node.j, node.limit)
            self.close_record(record)

    def change_phase(self):
        _, opens, phase = self.laws.changes[self.phases_done]
        self.laws.open[phase] = self.lie.phase(self, opens, phase)
        self.phases_done += 1
        self.close_record({"kind": "phase_begin" if opens else "phase_end", "phase": phase, "involved": [], "pre": {}})

    def push(self):
        i, impulse = self.lie.pushed(self, *self.laws.impulses[self.impulses_done][1:])
        self.impulses_done += 1
        record = {**self.open_record("scheduled_impulse", [i]), "dp": impulse}
        mass = self.body_mass(i)
        self.move_as_one(record, self.members(i), tuple(v + p / mass for v, p in zip(self.v[i], impulse)))
        self.close_record(record)

    # The whole run

    def write_state(self, final=False):
        self.out.state(self, final)

    def run(self, max_events):
        self.write_state()
        end = (float(self.scene["duration"]), 0.0)
        while True:
            if self.k >= max_events or self.lie.stops(self):
                return self.end("max_events", self.now)
            event = self.next_event()
            if event is None or event.time > end:
                endless = math.isinf(end[0])
                return self.end("no_more_events" if endless else "duration", self.now if endless else end)
            self.step(event)

    def end(self, reason, t):
        self.write_state(final=True)
        self.out.end(self.lie.ending(self, {"end": reason, "events": self.k, "t": t}))
        return self.out
