"""What the operations admit: a known answer to anything else is no answer. Standard library only; used by verify_vectors.py."""
import math

VECTORS = {"u_A", "u_B", "v_A", "v_B", "dp", "u", "v", "position", "velocity", "normal"}
TIMING, MASSES = ["u_A", "u_B", "v_A", "v_B", "L"], ["m_A", "m_B"]
PAIR, TETHER = ["u_A", "u_B", "v_A", "v_B", *MASSES], ["c_retract", "c_revolve", "theta_revolve_deg"]
KEYS = {
    "block_time": TIMING, "tether_time": TIMING,
    "apply_impulse": [*MASSES, "v_A", "v_B", "dp"], "restitution_impulse": [*MASSES, "v_A", "v_B", "dp"],
    "collision_impulse": [*PAIR, "c"], "revolution_impulse": [*PAIR, "c_revolve", "theta_revolve_deg"],
    "tether_response": [*PAIR, *TETHER], "load": [*MASSES, "v_A", "v_B"],
    "wall_time": [*TIMING, "normal"], "drag_time": ["gamma", "s"],
    "rough_impulse": [*PAIR, "spin_A", "spin_B", "R_A", "R_B", "c", "mu", "beta0"],
}
SCENE = {"tps", "dimension", "duration", "species", "pairs", "particles", "tethers"}


class OutsideDomain(ValueError):
    pass


def admit(holds, what):
    if not holds:
        raise OutsideDomain(f"no question of the operation: {what}")


def number(key, x):
    admit(isinstance(x, (str, int, float)) and not isinstance(x, bool), f"{key} is {x}, no number")
    try:
        x = float.fromhex(x) if isinstance(x, str) else float(x)
    except (ValueError, OverflowError):
        x = math.nan
    admit(not math.isnan(x), f"{key} is not a number")
    return x


def check_number(key, x):
    x = number(key, x)
    if key in ("L", "distance", "radius", "R_A", "R_B", "gamma"):
        admit((x > 0 or (x == 0 and key == "radius")) and math.isfinite(x), f"{key} is {x}; it is finite and above 0")
    elif key in ("m_A", "m_B", "m", "mass"):
        admit(x > 0, f"{key} is {x}; a mass is above 0, or inf")
    elif key in ("s", "mu"):
        admit(x >= 0 and math.isfinite(x), f"{key} is {x}; it is finite and at least 0")
    elif key == "beta0":
        admit(-1 <= x <= 1, f"{key} is {x}; it is in [-1, 1]")
    elif key.startswith("theta"):
        admit(1e-6 <= x <= 90 - 1e-6, f"{key} is {x}; it is in [1e-6, 89.999999] degrees")
    else:
        admit(0 <= x <= 1, f"{key} is {x}; a coefficient is in [0, 1]")


def check_numbers(q, keys):
    """Returns the dimension, 0 where there is no vector."""
    admit(isinstance(q, dict) and set(q) == set(keys), f"the keys are {', '.join(keys)}")
    dimensions = set()
    for key in keys:
        if key.startswith("spin"):  # one number in the plane, three in space
            components = q[key] if isinstance(q[key], list) else [q[key]]
            admit(len(components) == (1 if len(q["u_A"]) == 2 else 3), f"{key} has one component in the plane, three in space")
            admit(all(math.isfinite(number(key, x)) for x in components), f"components of {key} are finite")
            continue
        if key not in VECTORS:
            check_number(key, q[key])
            continue
        admit(isinstance(q[key], list) and len(q[key]) in (2, 3), f"{key} has 2 or 3 components")
        admit(all(math.isfinite(number(key, x)) for x in q[key]), f"components of {key} are finite")
        dimensions.add(len(q[key]))
    admit(len(dimensions) <= 1, "all vectors have one dimension")
    if "normal" in keys:
        admit(abs(math.hypot(*(number("normal", x) for x in q["normal"])) - 1) <= 2**-10, "normal has length 1, to 2^-10")
    if "m_A" in keys:
        admit(not number("m_A", q["m_A"]) == number("m_B", q["m_B"]) == math.inf, "two infinite masses never interact")
    if "u_A" in keys and "L" not in keys:
        admit(any(number("u", a) != number("u", b) for a, b in zip(q["u_A"], q["u_B"])), "u_A and u_B are one point")
    return max(dimensions, default=0)


def check_group(q):
    admit(set(q) == {"bodies", "collisions"}, "the keys are bodies, collisions")
    admit(len(q["bodies"]) <= 32 and len(q["collisions"]) <= 32, "there are at most 32 bodies and 32 collisions")
    admit(len({check_numbers(body, ["m", "u", "v"]) for body in q["bodies"]}) <= 1, "all bodies have one dimension")
    for c in q["collisions"]:
        admit(c.get("limit") in ("inner", "outer"), "limit is inner or outer")
        keys = ["c"] if c["limit"] == "inner" else TETHER
        check_numbers({k: c[k] for k in c if k not in ("i", "j", "limit")}, keys)
        for key in "ij":
            admit(type(c.get(key)) is int and 0 <= c[key] < len(q["bodies"]), f"{key} is a place in bodies")


def check_scene(scene):
    admit(set(scene) <= SCENE, f"known answers of next_event have {', '.join(sorted(SCENE))} only")
    admit(scene["tps"] == 1 and scene["dimension"] in (2, 3) and number("duration", scene["duration"]) > 0, "head of the scene")
    for species in scene["species"].values():
        check_numbers(species, ["mass", "radius"])
    for law in scene["pairs"]:
        admit(len(law["between"]) == 2 and all(s in scene["species"] for s in law["between"]), "species of a pair")
        check_numbers(law["blocking"], ["distance", "c_rebound"])
        if "tethering" in law:
            check_numbers(law["tethering"], ["distance", *TETHER])
            inner, outer = (number("distance", law[k]["distance"]) for k in ("blocking", "tethering"))
            admit(outer > inner * (1 + 1e-9), "the tethering distance exceeds the blocking distance")
    still = {tuple(map(float.fromhex, p["velocity"])) for p in scene["particles"]
             if number("mass", scene["species"][p["species"]]["mass"]) == math.inf}
    admit(len(still) <= 1, "infinite masses have one velocity")
    for n, particle in enumerate(scene["particles"]):
        admit(particle["id"] == n and particle["species"] in scene["species"], "ids count from 0; species exist")
        place = check_numbers({k: particle[k] for k in ("position", "velocity")}, ["position", "velocity"])
        admit(place == scene["dimension"], "vectors have the scene's dimension")
    for tether in scene.get("tethers", []):
        admit(len(set(tether)) == 2 and all(type(i) is int and 0 <= i < len(scene["particles"]) for i in tether), "tethers")


def check_question(op, q):
    """Raises OutsideDomain where the operation does not admit q."""
    if op == "order":
        admit(set(q) == {"first", "second"}, "the keys are first, second")
        for each in q.values():
            admit(each.get("kind") in ("block", "tether"), "kind is block or tether")
            check_numbers({k: x for k, x in each.items() if k != "kind"}, TIMING)
    elif op == "group":
        check_group(q)
    elif op == "next_event":
        admit(set(q) == {"scene"}, "the key is scene")
        check_scene(q["scene"])
    else:
        admit(op in KEYS, f"there is no operation {op}")
        check_numbers(q, KEYS[op])
