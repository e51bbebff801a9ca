"""Scenes that lies are told in: each a function of a seed, so that there are as many as one likes."""
import math
import random

from timing import exact_root


def ball(i, species, position, velocity):
    return {"id": i, "species": species, "position": list(position), "velocity": list(velocity)}


def apart(places, position, distance):
    return all(math.dist(p, position) > distance for p in places)


def scattered(draw, count, reach, distance, dimension=2):
    places = []
    while len(places) < count:
        position = [draw.uniform(-reach, reach) for _ in range(dimension)]
        if apart(places, position, distance):
            places.append(position)
    return places


def speed(draw, most=2.0, dimension=2):
    return [draw.uniform(-most, most) for _ in range(dimension)]


def tether(distance, **more):
    return {"distance": distance, "c_retract": 0.8, "c_revolve": 0.7, "theta_revolve_deg": 30, "form": "never", "break": "never", **more}


def gas(seed):
    """Discs of unequal masses in an enclosure: rebounds, retractions and revolutions."""
    draw = random.Random(seed)
    places = scattered(draw, 6, 2.4, 1.15)
    particles = [ball(2 * n + 1, "ab"[n % 2], p, speed(draw)) for n, p in enumerate(places)]
    around = {"mass": "inf", "radius": 4}
    walls = tether(3.5, c_retract=0.9, form="permanent")
    return {"tps": 1, "dimension": 2, "duration": 1000, "seed": seed,
            "species": {"a": {"mass": 1, "radius": 0.5}, "b": {"mass": 3.5, "radius": 0.5}, "around": around},
            "pairs": [{"between": ["a", "a"], "blocking": {"distance": 1, "c_rebound": 0.95}},
                      {"between": ["a", "b"], "blocking": {"distance": 1, "c_rebound": 0.5}},
                      {"between": ["b", "b"], "blocking": {"distance": 1, "c_rebound": 0.75}},
                      {"between": ["a", "around"], "tethering": walls}, {"between": ["b", "around"], "tethering": walls}],
            "particles": [ball(0, "around", [0, 0], [0, 0])] + particles}


def chain(seed):
    """Beads in space on tethers between two walls."""
    draw = random.Random(seed)
    beads = [ball(n, "bead" if n % 2 else "heavy", [float(n), draw.uniform(-0.05, 0.05), draw.uniform(-0.05, 0.05)], speed(draw, 1, 3))
             for n in range(5)]
    walls = [ball(10, "wall", [-2, 0, 0], [0, 0, 0]), ball(11, "wall", [6, 0, 0], [0, 0, 0])]
    between = {"blocking": {"distance": 0.75, "c_rebound": 0.9}, "tethering": tether(1.25)}
    return {"tps": 1, "dimension": 3, "duration": 1000, "seed": seed,
            "species": {"bead": {"mass": 1, "radius": 0.3}, "heavy": {"mass": 2.5, "radius": 0.3}, "wall": {"mass": "inf", "radius": 0.3}},
            "pairs": [{"between": pair, **between} for pair in (["bead", "bead"], ["bead", "heavy"], ["heavy", "heavy"])]
            + [{"between": [s, "wall"], "blocking": {"distance": 1.5, "c_rebound": 0.8}} for s in ("bead", "heavy")],
            "particles": beads + walls, "tethers": [[n, n + 1] for n in range(4)]}


def grouped(scene, dt):
    return lambda seed: {**scene(seed), "grouping": {"dt_restitute": dt}}


def sticky(seed):
    """Tethers that form and break by every rule, capacities, phases and impulses."""
    draw = random.Random(seed)
    places = scattered(draw, 8, 2.6, 0.95)
    particles = [ball(n + 1, "vs"[n % 2], p, speed(draw)) for n, p in enumerate(places)]
    walls = tether(3.5, c_retract=1, form="permanent")
    return {"tps": 1, "dimension": 2, "duration": 1000, "seed": seed,
            "species": {"v": {"mass": 1, "radius": 0.4, "max_tethers": 1}, "s": {"mass": 0.25, "radius": 0.2, "max_tethers": 1},
                        "around": {"mass": "inf", "radius": 4}},
            "pairs": [{"between": ["s", "v"], "blocking": {"distance": 0.6, "c_rebound": 0.9},
                       "tethering": tether(0.9, form="always", **{"break": {"impulse_above": 0.15}})},
                      {"between": ["s", "s"], "blocking": {"distance": 0.4, "c_rebound": 1},
                       "tethering": tether(0.8, form={"probability": 0.5}, **{"break": {"probability": 0.5}})},
                      {"between": ["v", "v"], "blocking": {"distance": 0.8, "c_rebound": 1},
                       "tethering": tether(1.2, form="always", **{"break": "always"})},
                      {"between": ["v", "around"], "tethering": walls}, {"between": ["s", "around"], "tethering": walls}],
            "phases": [{"from": 0.5, "until": 1.25, "between": ["s", "v"], "form": "never", "break": "always"},
                       {"from": 1.25, "until": "inf", "between": ["s", "v"], "form": "always", "break": "never"}],
            "impulses": [{"at": 0.75 * n + 0.3, "particle": 1 + n, "impulse": speed(draw)} for n in range(8)],
            "particles": [ball(0, "around", [0, 0], [0, 0])] + particles}


def lottery(seed):
    """Tethers that form and break by chance only."""
    scene = gas(seed)
    scene["species"] = {"a": {"mass": 1, "radius": 0.5, "max_tethers": 2}, **{k: v for k, v in scene["species"].items() if k != "a"}}
    chance = {"form": {"probability": 0.5}, "break": {"probability": 0.5}}
    for pair in scene["pairs"][:3]:
        pair["tethering"] = tether(1.5, **chance)
    return scene


def pushed_group(seed):
    """Impulses that meet particles while they are grouped."""
    draw = random.Random(seed)
    pushes = [{"at": 0.2 * n + 0.1, "particle": 2 * draw.randint(0, 5) + 1, "impulse": speed(draw)} for n in range(30)]
    return {**gas(seed), "grouping": {"dt_restitute": 0.5}, "impulses": pushes}


def sticky_grouped(seed):
    return {**sticky(seed), "grouping": {"dt_restitute": 0.2}}


def lone_pairs(seed, pairs, duration="inf", c=1.0, extra=()):
    """Discs of the limit 1 in pairs far from each other: (gap, offset, velocity) each."""
    particles = []
    for n, (r, v) in enumerate(pairs):
        particles += [ball(2 * n, "a", [0, 64 * n], [0, 0]), ball(2 * n + 1, "a", [r[0], 64 * n + r[1]], v)]
    return {"tps": 1, "dimension": 2, "duration": duration, "seed": seed, "species": {"a": {"mass": 1, "radius": 0.5}},
            "pairs": [{"between": ["a", "a"], "blocking": {"distance": 1, "c_rebound": c}}], "particles": particles, **dict(extra)}


def graze(seed):
    """One graze, shallow but deep enough for any rounding, and later a plain hit."""
    draw = random.Random(seed)
    depth = 10 ** draw.uniform(-8, -3)
    start = draw.uniform(2, 20)
    return lone_pairs(seed, [([-start, 1 - depth], [1.0, 0.0]), ([-start - 5, 0.3125], [1.0, 0.0])], duration=50)


def exact_graze(seed):
    """A graze that only exact arithmetic sees."""
    draw = random.Random(seed)
    start = draw.uniform(1, 20)
    return lone_pairs(seed, [([-start, 1 - 2.0 ** -draw.randint(48, 53)], [1.0, 0.0]), ([-start - 5, 0.3125], [1.0, 0.0])], duration=50)


def crossing(seed):
    """Two tiny fast bodies meet between the slow events of others."""
    draw = random.Random(seed)
    scene = lone_pairs(seed, [([-draw.uniform(3, 4), 0.2], [0.5, 0.0]), ([draw.uniform(6, 8), 0.4], [-0.5, 0.01])])
    scene["species"]["mote"] = {"mass": 0.001, "radius": 0.0005}
    scene["pairs"].append({"between": ["mote", "mote"], "blocking": {"distance": 0.001, "c_rebound": 1}})
    x, v = draw.uniform(1, 3), draw.uniform(500, 2000)
    scene["particles"] += [ball(20, "mote", [-x, 30.0], [v, 0.0]), ball(21, "mote", [x, 30.0003], [-v, 0.0])]
    return scene


def twins(seed):
    """Two or three pairs that are copies of each other: exact ties."""
    draw = random.Random(seed)
    pair = ([draw.randint(2, 9) + draw.choice([0.0, 0.5]), draw.choice([0.0, 0.25, 0.5])], [-draw.randint(1, 4) / 2, 0.0])
    return lone_pairs(seed, [pair] * draw.choice([2, 3]), duration=50)


def near_twins(seed):
    """Two pairs whose exact times differ and round to one double; the pair of higher ids is the earlier one."""
    draw = random.Random(seed)
    while True:
        r, v = [draw.uniform(2, 4), draw.randint(1, 600) / 1024], [-draw.uniform(1, 2), 0.0]
        faster = [math.nextafter(v[0], -math.inf), 0.0]
        times = [exact_root((0.0, 0.0), tuple(r), (0.0, 0.0), tuple(w), 1.0, "inner").rounded() for w in (v, faster)]
        if times[0] == times[1]:
            return lone_pairs(seed, [(r, v), (r, faster)], duration=50)


def tied_group(seed):
    """A restitution due at the very time of another pair's collision."""
    draw = random.Random(seed)
    gap, dt = draw.randint(1, 4), draw.choice([0.5, 1.0, 2.0])
    hit = ([1.0 + gap, 0.0], [-1.0, 0.0])
    return lone_pairs(seed, [hit, ([1.0 + gap + dt, 0.0], [-1.0, 0.0]), hit], c=0.5, extra={"grouping": {"dt_restitute": dt}}.items())


def tied_impulse(seed):
    """An impulse and a phase at the very time of a collision: ranks decide."""
    draw = random.Random(seed)
    gap = draw.randint(1, 4)
    scene = lone_pairs(seed, [([1.0 + gap, 0.0], [-1.0, 0.0]), ([3.0 + gap, 0.0], [-1.0, 0.0])], duration=50)
    scene["impulses"] = [{"at": gap, "particle": 3, "impulse": [-0.5, 0.25]}]
    return scene


def dead(seed):
    """c = 0: a ball meets a wall head-on along an axis, stops without any rounding, and rests there for long."""
    draw = random.Random(seed)
    scene = lone_pairs(seed, [([draw.uniform(2, 4), 0.0], [-draw.uniform(1, 2), 0.0])], duration=1e6, c=0)
    scene["species"]["wall"] = {"mass": "inf", "radius": 0.5}
    scene["particles"][0]["species"] = "wall"
    scene["pairs"] = [{"between": ["a", "wall"], "blocking": {"distance": 1, "c_rebound": 0}}]
    return scene


SCENES = {"gas": gas, "chain": chain, "gas_grouped": grouped(gas, 0.15), "chain_grouped": grouped(chain, 0.25), "sticky": sticky,
          "sticky_grouped": sticky_grouped, "lottery": lottery, "lottery_grouped": grouped(lottery, 0.1), "pushed_group": pushed_group, "graze": graze, "exact_graze": exact_graze, "crossing": crossing, "twins": twins,
          "near_twins": near_twins, "tied_group": tied_group, "tied_impulse": tied_impulse, "dead": dead}
