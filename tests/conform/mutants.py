"""Wrong adapters, one switch each: a text of data/adapters/python that is replaced, and what `tps conform` has to say of it.

Mutant(name, file, old, new, op, hypothesis): the rows of `op` must be WRONG, and where a hypothesis is named it must be the one that
is printed for one of them. `only` says that no other operation may have a wrong answer.
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    name: str
    file: str
    old: str
    new: str
    op: str
    equals: str = ""
    kind: str = "WRONG"
    level: str = "1"

    def asked(self):
        """Both timing queries, since their laws ask both."""
        return "block_time,tether_time" if self.op in ("block_time", "tether_time") else self.op


T, R, G, P, E = "timing.py", "responses.py", "groups.py", "protocol.py", "effects.py"
HIT = '"t": c / (-h + math.sqrt(D))}'
PULL = '"t": -c / (h + math.sqrt(D)) if h > 0 else (-h + math.sqrt(D)) / a}'
ROOT = "c = (distance - L) * (distance + L)"
VELOCITY = "r, v = minus(u_B, u_A), minus(v_B, v_A)\n    a, h"
REVOLVED = "speed = c_revolve ** (theta_revolve_deg / 180) * math.sqrt(dot(v, v))"
DECIDES = "if across == 0 or abs(c_retract * v_n) > slope(theta_revolve_deg) * across:"
FLOAT32 = "single = lambda xs: [struct.unpack('f', struct.pack('f', x))[0] for x in xs]"

WRONG = [
    Mutant("larger_root", T, HIT, '"t": (-h + math.sqrt(D)) / a}', "block_time", "the larger root"),
    Mutant("smaller_root", T, PULL, '"t": (-h - math.sqrt(D)) / a}', "tether_time", "the smaller root"),
    Mutant("no_approach_test", T, "if a == 0 or h >= 0:", "if a == 0:", "block_time"),
    Mutant("before_now", T, '    if a == 0 or h >= 0:\n        return {"verdict": "static" if a == 0 else "receding", "t": None}\n    if c <= 0:',
           '    if a == 0:\n        return {"verdict": "static", "t": None}\n    if D > 0 and -h + math.sqrt(D) == 0:', "block_time", "a time before now"),
    Mutant("divided_by_a", T, HIT, '"t": 2 * c / (-h + math.sqrt(D))}', "block_time", "twice the time: the quadratic divided by a instead of 2a"),
    Mutant("limit_not_squared", T, ROOT, "c = distance * distance - L; L = math.sqrt(L)", "block_time", "L taken as it is instead of squared"),
    Mutant("limit_as_radius", T, ROOT, "L = 2 * L; " + ROOT, "block_time", "L doubled, as if it were a radius"),
    Mutant("velocity_reversed", T, VELOCITY, VELOCITY.replace("minus(v_B, v_A)", "minus(v_A, v_B)"), "block_time",
           "the relative velocity with the wrong sign"),
    Mutant("closest_approach", T, HIT, '"t": -h / a}', "block_time", "the time of closest approach"),
    Mutant("overlap_ignored", T, '{"verdict": "overlap" if c < 0 else "contact", "t": 0}', '{"verdict": "miss", "t": None}', "block_time",
           "no event for a pair that is at its limit or beyond it"),
    Mutant("overstretched_lost", T, '{"verdict": "overstretched" if c > 0 else "taut", "t": 0}', '{"verdict": "never", "t": None}', "tether_time",
           "no event for a pair that is at its limit or beyond it"),
    Mutant("turning_lost", T, '"turning", "t": -h / a', '"static", "t": None', "tether_time"),
    Mutant("nan_on_static", T, '"static" if a == 0 else "receding", "t": None', '"static" if a == 0 else "receding", "t": math.nan if a == 0 else None',
           "block_time"),
    Mutant("late_by_1e-13", T, HIT, '"t": c / (-h + math.sqrt(D)) * (1 + 1e-13)}', "block_time"),
    Mutant("threshold_on_velocity", T, 'if a == 0 or h >= 0:\n        return {"verdict": "static" if a == 0',
           'if a < 1e-12 or h >= 0:\n        return {"verdict": "static" if a < 1e-12', "block_time", "a threshold where the paper has 0"),
    Mutant("threshold_on_approach", T, "if a == 0 or h >= 0:", "if a == 0 or h >= -5e-10:", "block_time", "a threshold where the paper has 0"),
    Mutant("threshold_on_speed_of_tethers", T, 'if a == 0:\n        return {"verdict": "static"', 'if a < 1e-12:\n        return {"verdict": "static"', "tether_time",
           "a threshold where the paper has 0"),
    Mutant("single_precision_inside", T, "a, h, distance = dot(v, v)", "import struct; " + FLOAT32 + "; r, v = single(r), single(v)\n    a, h, distance = dot(v, v)",
           "block_time", "float32 inside"),
    Mutant("ten_digits", P, "return value.hex() if", 'return float(f"{value:.9e}").hex() if', "block_time", "written with 10 digits"),
    Mutant("remembered_without_L", T, "def quadratic(u_A, u_B, v_A, v_B, L):", "KNOWN = {}\n\n\ndef quadratic(u_A, u_B, v_A, v_B, L):\n"
           "    of = repr((u_A, u_B, v_A, v_B))\n    if of not in KNOWN:\n        KNOWN[of] = coefficients(u_A, u_B, v_A, v_B, L)\n    return KNOWN[of]\n\n\n"
           "def coefficients(u_A, u_B, v_A, v_B, L):", "block_time", "the answer to another question: remembered by too few of its numbers"),
    Mutant("six_decimals", P, "return value.hex() if", 'return float(f"{value:.6f}").hex() if', "load", "written with 6 decimals"),
    Mutant("half_refused", P, "try:\n        out", 'if request["seq"] % 2:\n        return {"error": "tired"}\n    try:\n        out', "load", kind="REFUSED"),
    Mutant("half_skipped", P, "if operation is None:", 'if operation is None or request["seq"] % 2:', "load", kind="REFUSED"),
    Mutant("order_reversed", T, "one, other = time(**first), time(**second)", "one, other = time(**second), time(**first)", "order",
           "first and second exchanged"),
    Mutant("ties_before", T, '"before" if one < other', '"before" if one <= other and one < math.inf', "order"),
    Mutant("same_way", R, "[v - p / m_B", "[v + p / m_B", "apply_impulse", "both particles pushed the same way"),
    Mutant("pushed_apart_wrongly", R, "[v + p / m_A for v, p in zip(v_A, dp)], \"v_B\": [v - p", "[v - p / m_A for v, p in zip(v_A, dp)], \"v_B\": [v + p",
           "apply_impulse", "A and B swapped"),
    Mutant("half_each", R, "def apply_impulse(m_A, m_B, v_A, v_B, dp):\n", "def apply_impulse(m_A, m_B, v_A, v_B, dp):\n    dp = [p / 2 for p in dp]\n",
           "apply_impulse", "half of Δp for each"),
    Mutant("masses_swapped", R, "v + p / m_A for v, p in zip(v_A, dp)], \"v_B\": [v - p / m_B", "v + p / m_B for v, p in zip(v_A, dp)], \"v_B\": [v - p / m_A",
           "apply_impulse", "m_A and m_B swapped"),
    Mutant("not_divided", R, "v + p / m_A for v, p in zip(v_A, dp)], \"v_B\": [v - p / m_B", "v + p for v, p in zip(v_A, dp)], \"v_B\": [v - p",
           "apply_impulse", "Δp not divided by the mass"),
    Mutant("infinite_mass_moves", R, "def apply_impulse(m_A, m_B, v_A, v_B, dp):\n", "def apply_impulse(m_A, m_B, v_A, v_B, dp):\n    m_A, m_B = (1e6 if m == math.inf else m for m in (m_A, m_B))\n",
           "apply_impulse"),
    Mutant("infinite_is_1e12", R, "return 1 / (1 / m_A + 1 / m_B)", "return 1 / sum(1 / (1e12 if m == math.inf else m) for m in (m_A, m_B))", "collision_impulse",
           "an infinite mass taken as a large finite one"),
    Mutant("infinite_is_1e18", R, "return 1 / (1 / m_A + 1 / m_B)", "return 1 / sum(1 / (1e18 if m == math.inf else m) for m in (m_A, m_B))", "collision_impulse"),
    Mutant("half_rebound", R, "(1 + c) * reduced", "c * reduced", "collision_impulse", "c instead of 1 + c"),
    Mutant("one_minus_c", R, "(1 + c) * reduced", "(1 - c) * reduced", "collision_impulse", "1 − c instead of 1 + c"),
    Mutant("elastic", R, "(1 + c) * reduced", "2 * reduced", "collision_impulse", "c taken as 1"),
    Mutant("inelastic", R, "(1 + c) * reduced", "reduced", "collision_impulse", "c taken as 0"),
    Mutant("half_a_unit_vector", R, "v_n = dot(v, n)", "v_n = dot(v, r)", "collision_impulse", "the axis a unit vector once of twice"),
    Mutant("impulse_off_by_1e-12", R, "(1 + c) * reduced", "(1 + 1e-12) * (1 + c) * reduced", "collision_impulse"),
    Mutant("axis_swapped", R, "(1 + c) * reduced", "-(1 + c) * reduced", "collision_impulse", "A and B swapped"),
    Mutant("no_unit_vector", R, "n = [x / distance for x in r]", "n = r", "collision_impulse", "the axis not a unit vector"),
    Mutant("whole_velocity", R, "n, _, v_n, _ = frame(**pair)\n    return {\"dp\": [(1 + c) * reduced_mass(m_A, m_B) * (v_n * x)",
           "_, n, v_n, _ = frame(**pair)\n    return {\"dp\": [(1 + c) * reduced_mass(m_A, m_B) * x",
           "collision_impulse", "the whole relative velocity instead of its normal part"),
    Mutant("sum_of_masses", R, "return 1 / (1 / m_A + 1 / m_B)", "return m_A + m_B", "collision_impulse", "m_A + m_B instead of the reduced mass"),
    Mutant("smaller_mass", R, "return 1 / (1 / m_A + 1 / m_B)", "return min(m_A, m_B)", "collision_impulse", "the smaller mass instead of the reduced mass"),
    Mutant("two_of_three", R, "v_n = dot(v, n)", "v_n = dot(v[:2], n[:2])", "collision_impulse", "v_n of two components of three"),
    Mutant("one_mass", R, "return 1 / (1 / m_A + 1 / m_B)", "return m_A", "collision_impulse", "m_A instead of the reduced mass"),
    Mutant("product_as_printed", R, REVOLVED, REVOLVED.replace("c_revolve ** (theta_revolve_deg / 180)", "c_revolve * theta_revolve_deg / 180"),
           "revolution_impulse", "the product c·θ/π as printed instead of the power (D4)"),
    Mutant("degrees_as_radians", R, "math.tan(math.radians(degrees)) if degrees <= 45 else 1 / math.tan(math.radians(90 - degrees))", "math.tan(degrees)",
           "revolution_impulse", "tan of θ taken as radians"),
    Mutant("radians", R, "n, v, _, w = frame(**pair)\n    inward", "n, v, _, w = frame(**pair)\n    theta_revolve_deg = math.degrees(theta_revolve_deg)\n    inward",
           "revolution_impulse", "θ taken as radians"),
    Mutant("speed_kept", R, REVOLVED, "speed = math.sqrt(dot(v, v))", "revolution_impulse", "c_revolve taken as 1"),
    Mutant("speed_across_alone", R, REVOLVED, REVOLVED.replace("dot(v, v)", "dot(w, w)"), "revolution_impulse", "|v_ŵ| instead of |v_AB|"),
    Mutant("outward", R, "x - inward * y", "x + inward * y", "revolution_impulse", "outward instead of inward"),
    Mutant("every_collision", R, "(theta_revolve_deg / 180)", "1.0", "revolution_impulse", "c_revolve for every collision instead of a revolution"),
    Mutant("two_pi", R, "(theta_revolve_deg / 180)", "(theta_revolve_deg / 360)", "revolution_impulse", "c_revolve to the power θ/2π"),
    Mutant("always_retracts", R, DECIDES, "if True:", "tether_response", "retracts where it has to revolve"),
    Mutant("always_revolves", R, DECIDES, "if across == 0:", "tether_response", "revolves where retraction suffices"),
    Mutant("threshold_without_c", R, "abs(c_retract * v_n) >", "abs(v_n) >", "tether_response", "retracts where it has to revolve"),
    Mutant("other_coefficient", R, '"retract", collision_impulse(m_A, m_B, c_retract', '"retract", collision_impulse(m_A, m_B, c_revolve',
           "tether_response", "c_revolve instead of c_retract"),
    Mutant("mean_velocity", R, "1 / (1 + m_B / m_A) * a + 1 / (1 + m_A / m_B) * b", "(a + b) / 2", "load", "the mean of both velocities"),
    Mutant("weights_swapped", R, "* a + 1 / (1 + m_A / m_B) * b", "* b + 1 / (1 + m_A / m_B) * a", "load", "the weights swapped"),
    Mutant("no_subtraction", R, "p - reduced_mass(m_A, m_B) * v for p, v", "p for p, v", "restitution_impulse", "(7) without its subtraction"),
    Mutant("added", R, "p - reduced_mass(m_A, m_B) * v for p, v", "p + reduced_mass(m_A, m_B) * v for p, v", "restitution_impulse",
           "added instead of subtracted"),
    Mutant("mass_of_one", G, "m[k], v[k], members[k] = mass, joint, both", "v[k], members[k] = joint, both", "group",
           "the mass of one particle instead of its group's"),
    Mutant("group_without_subtraction", G, 'dp=dp, **masses)["dp_AB"]))', 'dp=dp, **masses)["dp_AB"] and dp))', "group", "(7) without its subtraction"),
    Mutant("group_stays_behind", G, "for k in both:\n            m[k], v[k], members[k] = mass, joint, both",
           "for k in both:\n            m[k], members[k] = mass, both\n        v[i] = v[j] = joint", "group",
           "only the two particles take the common velocity, not their groups"),
    Mutant("centre_at_the_wall", E, " - L\n", "\n", "wall_time", "the centre instead of the surface of the particle"),
    Mutant("wall_crossed", E, '{"verdict": "overlap" if gap < 0 else "contact", "t": 0}', '{"verdict": "receding", "t": None}', "wall_time",
           "a particle that is at the plane or behind it lost"),
    Mutant("behind_the_wall", E, "towards = -dot(normal, v)", "gap, towards = -gap - 2 * L, dot(normal, v)", "wall_time", "the normal turned round"),
    Mutant("distance_for_time", E, '"t": gap / towards}', '"t": gap}', "wall_time", "the distance from the plane instead of the time to it"),
    Mutant("whole_speed", E, '"t": gap / towards}', '"t": gap / math.sqrt(dot(v, v))}', "wall_time", "the whole speed instead of that towards the plane"),
    Mutant("clock_for_time", E, "-math.log1p(-gamma * s) / gamma}", "s}", "drag_time", "s itself"),
    Mutant("not_divided_by_gamma", E, "-math.log1p(-gamma * s) / gamma}", "-math.log1p(-gamma * s)}", "drag_time", "the logarithm not divided by γ"),
    Mutant("other_way_round", E, "-math.log1p(-gamma * s) / gamma}", "-math.expm1(-gamma * s) / gamma}", "drag_time", "s of t instead of t of s"),
    Mutant("time_goes_on", E, 'if gamma * s >= 1:', "if gamma * s > 1e9:", "drag_time", kind="REFUSED"),
    Mutant("no_friction", E, "dp, turn = [x + y for x, y in zip(normal, across)]", "dp, turn = normal", "rough_impulse", "without friction"),
    Mutant("friction_reversed", E, "across = [factor * x if sticks else most * (x / slip) for x in g]", "across = [-factor * x if sticks else -most * (x / slip) for x in g]",
           "rough_impulse", "friction the other way"),
    Mutant("spin_of_one", E, "R_A * x + R_B * y for", "R_A * x for", "rough_impulse", "B's spin left out"),
    Mutant("spins_against", E, "R_A * x + R_B * y for", "R_A * x - R_B * y for", "rough_impulse", "B's spin with the other sign"),
    Mutant("always_holds", E, "sticks = factor * slip <= most", "sticks = True", "rough_impulse", "surfaces always hold"),
    Mutant("spheres_everywhere", E, "1 / 2 if is_planar else 2 / 5", "2 / 5", "rough_impulse", "the mass of a sphere's contact for a disc"),
    Mutant("whole_mass", E, "(1 + beta0) * K / (1 + K) * reduced", "(1 + beta0) * reduced", "rough_impulse", "the reduced mass instead of that of the contact"),
    Mutant("beta_alone", E, "(1 + beta0) * K", "beta0 * K", "rough_impulse", "β₀ instead of 1 + β₀"),
    Mutant("turns_the_other_way", E, "cross(n, across)", "cross(across, n)", "rough_impulse"),
]

# Tolerances where the paper has none: coarse ones are found by the ten cases a file that level 1 asks, fine ones by level 2.
for size, level in (("1e-3", "1"), ("1e-6", "2"), ("1e-10", "2")):
    WRONG += [
        Mutant(f"threshold_off_by_{size}", R, "> slope(theta_revolve_deg) * across:", f"> slope(theta_revolve_deg) * across * (1 + {size}):",
               "tether_response", level=level),
        Mutant(f"holds_within_{size}", E, "sticks = factor * slip <= most", f"sticks = factor * slip <= most * (1 + {size})", "rough_impulse", level=level),
        Mutant(f"wall_within_{size}", E, "if gap <= 0:", f"if gap <= {size} * L:", "wall_time", level=level),
        Mutant(f"contact_within_{size}", T, "    if c <= 0:", f"    if c <= {size} * query['L'] ** 2:", "block_time", level=level),
        Mutant(f"receding_within_{size}", T, "if a == 0 or h >= 0:", f"if a == 0 or h >= -{size} * math.sqrt(a) * query['L']:", "block_time", level=level),
        Mutant(f"taut_within_{size}", T, "if c >= 0 and h >= 0:", f"if c >= -{size} * query['L'] ** 2 and h >= 0:", "tether_time", level=level),
        Mutant(f"ties_within_{size}", T, '"before" if one < other', f'"equal" if one != math.inf and abs(one - other) <= {size} * one else "before" if one < other',
               "order", level=level),
        Mutant(f"clock_ends_{size}_early", E, "if gamma * s >= 1:", f"if gamma * s >= 1 - {size}:", "drag_time", level=level),
    ]
# What a family of questions of its own asks: a pull from the centre, hardly any restitution, motion all but along the axis, components of
# very different sizes, a container in a group.
DROPPED = "dp = [*dp[:2], 0.0] if len(dp) == 3 and abs(dp[2]) < 1e-3 * abs(dp[0]) else dp\n    "
WRONG += [
    Mutant("taut_at_the_centre", T, "    if c >= 0 and h >= 0:", '    if query["u_A"] == query["u_B"]:\n        return {"verdict": "taut", "t": 0}\n    if c >= 0 and h >= 0:',
           "tether_time"),
    Mutant("never_from_the_centre", T, "    t = (block_time", '    if query["u_A"] == query["u_B"]:\n        return math.inf\n    t = (block_time', "order"),
    Mutant("all_but_along_is_along", R, "if across == 0 or", "if across < 1e-3 * abs(v_n) or", "tether_response"),
    Mutant("all_but_plastic_is_plastic", R, "(1 + c) * reduced", "(1 + (0 if c < 1e-9 else c)) * reduced", "collision_impulse", level="2"),
    Mutant("hardly_revolves_is_at_rest", R, REVOLVED, "c_revolve = 0 if c_revolve < 1e-9 else c_revolve; " + REVOLVED, "revolution_impulse", level="2"),
    Mutant("small_component_dropped", R, 'return {"v_A": [v + p', DROPPED + 'return {"v_A": [v + p', "apply_impulse", level="2"),
    Mutant("small_component_not_restituted", R, 'return {"dp_AB"', DROPPED + 'return {"dp_AB"', "restitution_impulse", level="2"),
    Mutant("twice_at_a_container", G, "    return (tether_response", "    if limit == \"outer\" and math.inf in (m[i], m[j]):\n        return [2 * x for x in tether_response(**pair, **coefficients)[\"dp\"]]\n    return (tether_response",
           "group"),
]
# A number all but special taken for the special one, other units of mass, times that are very long or very short.
REVOLVES, RETRACTS = 'dp = "revolve", revolution_impulse(m_A, m_B, ', 'dp = "retract", collision_impulse(m_A, m_B, '
DISC = "    K = 1 / 2 if is_planar else 2 / 5\n"
WRONG += [
    Mutant("both_due_now_is_none", T, '"none" if one == math.inf', '"none" if one == math.inf or one == 0', "order"),
    Mutant("block_first_of_both_due_now", T, '    return {"order": "before" if one',
           '    if one == other == 0 and first["kind"] != second["kind"]:\n        return {"order": "before" if first["kind"] == "block" else "after"}\n'
           '    return {"order": "before" if one', "order", level="2"),
    Mutant("ties_within_1e-12_of_the_unit", T, '"before" if one < other', '"equal" if one != math.inf and abs(one - other) <= 1e-12 else "before" if one < other', "order",
           level="2"),
    Mutant("far_in_time_is_none", T, "math.inf if t is None", "math.inf if t is None or t > 1e30", "order", level="2"),
    Mutant("far_in_time_is_a_miss", T, HIT, HIT[:-1] + '} if c < 1e30 * (-h + math.sqrt(D)) else {"verdict": "miss", "t": None}', "block_time", level="2"),
    Mutant("deep_inside_is_receding", T, "    if c <= 0:", '    if c < -0.98 * query["L"] ** 2:\n        return {"verdict": "receding", "t": None}\n    if c <= 0:',
           "block_time", level="2"),
    Mutant("about_45_degrees_is_45", R, REVOLVED, "theta_revolve_deg = 45 if abs(theta_revolve_deg - 45) < 1e-3 else theta_revolve_deg; " + REVOLVED,
           "revolution_impulse", level="2"),
    Mutant("revolves_elastically", R, REVOLVED, "c_revolve = 1 if c_revolve > 1 - 1e-6 else c_revolve; " + REVOLVED, "revolution_impulse", level="2"),
    Mutant("pulled_elastically", R, RETRACTS + "c_retract", RETRACTS + "1 if c_retract > 1 - 1e-6 else c_retract", "tether_response", level="2"),
    Mutant("like_masses_are_equal", R, "    n, _, v_n, _ = frame(**pair)", "    m_B = m_A if abs(m_A - m_B) < 1e-6 * m_A else m_B\n    n, _, v_n, _ = frame(**pair)",
           "collision_impulse", level="2"),
    Mutant("light_masses_are_heavier", R, 'return {"v_A": [v + p', 'm_A, m_B = max(m_A, 1e-16), max(m_B, 1e-16)\n    return {"v_A": [v + p', "apply_impulse", level="2"),
    Mutant("heavy_masses_are_infinite", R, 'return {"v_A": [v + p',
           'm_A, m_B = (math.inf if m > 1e16 else m for m in (m_A, m_B))\n    return {"v_A": [v + p', "apply_impulse", level="2"),
    Mutant("leaning_wall_is_upright", E, "    v, gap = minus", "    normal = [round(x) if abs(x - round(x)) < 1e-6 else x for x in normal]\n    v, gap = minus",
           "wall_time", level="2"),
    *(Mutant(f"all_but_{name}", E, DISC, f"    {line}\n{DISC}", "rough_impulse", level="2") for name, line in (
        ("elastic_disc", "c = 1 if c > 1 - 1e-6 else c"), ("perfectly_rough", "beta0 = 1 if beta0 > 1 - 1e-6 else beta0"),
        ("perfectly_smooth", "beta0 = -1 if beta0 < -1 + 1e-6 else beta0"),
        ("equal_discs", "m_B = m_A if abs(m_A - m_B) < 1e-6 * m_A else m_B"),
        ("equal_spins", "spins[1] = [x if abs(x - y) < 1e-6 * abs(x) else y for x, y in zip(*spins)]"))),
    Mutant("plastic_without_its_friction", E, "most = mu * math.sqrt(dot(normal, normal))",
           "most = mu * math.sqrt(dot(normal, normal)) / (1 + c) * (1 + c if c > 1e-9 else 1)", "rough_impulse", level="2"),
]
WRONG.append(Mutant("almost_elastic_is_elastic", R, "(1 + c) * reduced", "(1 + (1 if c > 0.99 else c)) * reduced", "collision_impulse"))

# Right, but by other words or not the same bits.
RIGHT = [
    Mutant("squares", T, "distance = dot(v, v), dot(r, v), math.sqrt(dot(r, r))", "distance = sum(x ** 2 for x in v), dot(r, v), math.hypot(*r)", "block_time"),
    Mutant("inverse_masses", R, "p / m_A for v, p in zip(v_A, dp)], \"v_B\": [v - p / m_B", "p * (1 / m_A) for v, p in zip(v_A, dp)], \"v_B\": [v - p * (1 / m_B)",
           "apply_impulse"),
    Mutant("times_alone", T, '"verdict": "hit", "t": c /', '"t": c /', "block_time"),
    Mutant("strict_or_not", R, "abs(c_retract * v_n) >", "abs(c_retract * v_n) >=", "tether_response"),
    Mutant("tan_as_it_is", R, "math.tan(math.radians(degrees)) if degrees <= 45 else 1 / math.tan(math.radians(90 - degrees))", "math.tan(math.radians(degrees))",
           "tether_response"),
    Mutant("unwound_forward", G, "in reversed(nodes)", "in nodes", "group"),
]
