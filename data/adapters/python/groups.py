"""Groups of nearly simultaneous collisions: eqs. (6), (7) and (3), nested (docs/semantics.md, section 4)."""
import math

from protocol import serve
from responses import apply_impulse, collision_impulse, load, restitution_impulse, tether_response


def impulse(bodies, v, m, i, j, limit="inner", **coefficients):
    pair = {"u_A": bodies[i]["u"], "u_B": bodies[j]["u"], "v_A": v[i], "v_B": v[j], "m_A": m[i], "m_B": m[j]}
    return (tether_response if limit == "outer" else collision_impulse)(**pair, **coefficients)["dp"]


def group(bodies, collisions):
    m, v = [body["m"] for body in bodies], [body["v"] for body in bodies]
    # An infinite mass joins no group: what is loaded against it takes its velocity and its mass.
    members = [[] if mass == math.inf else [k] for k, mass in enumerate(m)]
    nodes = []
    for collision in collisions:
        i, j = collision["i"], collision["j"]
        masses = {"m_A": m[i], "m_B": m[j]}
        dp = impulse(bodies, v, m, **collision)
        nodes.append((members[i], members[j], masses, restitution_impulse(v_A=v[i], v_B=v[j], dp=dp, **masses)["dp_AB"]))
        both, joint, mass = members[i] + members[j], load(v_A=v[i], v_B=v[j], **masses)["v_load"], m[i] + m[j]
        for k in both:
            m[k], v[k], members[k] = mass, joint, both
    loaded = list(v)
    for first, second, masses, dp in reversed(nodes):
        for k in first:
            v[k] = apply_impulse(v_A=v[k], v_B=v[k], dp=dp, **masses)["v_A"]
        for k in second:
            v[k] = apply_impulse(v_A=v[k], v_B=v[k], dp=dp, **masses)["v_B"]
    return {"loaded": loaded, "restituted": v}


OPERATIONS = {"group": group}
if __name__ == "__main__":
    serve("Python, groups", OPERATIONS)
