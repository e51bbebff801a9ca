"""Lies about what a collision does: impulses and velocities."""
import math

from lie import ALL, GROUPED, Lie, lie
from numbers_of_traces import minus, next_after, norm, plus, times
from responses import collision_impulse, reduced_mass, retraction_suffices, revolution_impulse
from timing import INNER

UNIT = 2.0**-53


class Impulse(Lie):
    """Another Δp; the velocities follow from it. `limit` and `kind` say of which collisions."""

    limit = kind = None

    def impulse(self, sim, hit):
        meant = self.limit in (None, hit.limit) and self.kind in (None, hit.kind)
        if not self.now(sim) or not hit.answered or not meant:
            return
        dp = self.instead(sim, hit)
        if dp is not None and norm(minus(dp, hit.dp)) > 1e-13 * self.least * norm(hit.dp):
            hit.dp = dp
            self.tell()

    least = 1e6


def coefficients(sim, hit):
    return sim.laws.blocking(hit.i, hit.j), sim.laws.tethering(hit.i, hit.j)


@lie("impulse", ALL)
class OffByFourBounds(Impulse):
    """Along the axis, by four times what eq. (4) may be off by (8 u (1 + c) μ |v_AB|)."""

    limit, least = INNER, 0

    def instead(self, sim, hit):
        c = sim.laws.blocking(hit.i, hit.j)["c_rebound"]
        size = 32 * UNIT * (1 + c) * reduced_mass(hit.m_i, hit.m_j) * norm(hit.frame.relative)
        return plus(hit.dp, hit.frame.axis, size)


@lie("impulse", ALL, minimal=True)
class SignTurned(Impulse):
    def instead(self, sim, hit):
        return times(-1.0, hit.dp)


@lie("impulse", ALL, minimal=True)
class WithoutOnePlus(Impulse):
    limit = INNER

    def instead(self, sim, hit):
        return collision_impulse(hit.frame, hit.m_i, hit.m_j, sim.laws.blocking(hit.i, hit.j)["c_rebound"] - 1)


@lie("impulse", "chain chain_grouped", minimal=True)
class RetractForRebound(Impulse):
    limit = INNER

    def instead(self, sim, hit):
        law = sim.laws.tethering(hit.i, hit.j)
        return collision_impulse(hit.frame, hit.m_i, hit.m_j, law["c_retract"]) if law else None


@lie("impulse", "chain chain_grouped", minimal=True)
class ReboundForRetract(Impulse):
    kind = "retract"

    def instead(self, sim, hit):
        return collision_impulse(hit.frame, hit.m_i, hit.m_j, sim.laws.blocking(hit.i, hit.j)["c_rebound"])


@lie("impulse", ALL, minimal=True)
class Elastic(Impulse):
    limit = INNER

    def instead(self, sim, hit):
        return collision_impulse(hit.frame, hit.m_i, hit.m_j, 1.0)


class Revolution(Impulse):
    kind = "revolve"

    def law(self, sim, hit):
        law = sim.laws.tethering(hit.i, hit.j)
        return float(law["c_revolve"]), float(law["theta_revolve_deg"])


@lie("impulse", "chain chain_grouped gas", minimal=True)
class ProductForPower(Revolution):
    """c θ/π as the paper prints it, not c to the power θ/π."""

    def instead(self, sim, hit):
        c, theta = self.law(sim, hit)
        return revolution_impulse(hit.frame, hit.m_i, hit.m_j, c, theta, exponent=c * theta / 180)


@lie("impulse", "chain chain_grouped gas", minimal=True)
class DegreesForRadians(Revolution):
    def instead(self, sim, hit):
        c, theta = self.law(sim, hit)
        return revolution_impulse(hit.frame, hit.m_i, hit.m_j, c, theta, slope=math.tan(theta))


@lie("impulse", "chain chain_grouped gas", minimal=True)
class WholePower(Revolution):
    """c instead of c^(θ/π): the loss of a whole revolution at each collision."""

    def instead(self, sim, hit):
        c, theta = self.law(sim, hit)
        return revolution_impulse(hit.frame, hit.m_i, hit.m_j, c, theta, exponent=c)


@lie("impulse", "chain chain_grouped gas", minimal=True)
class RetractsForRevolve(Revolution):
    def instead(self, sim, hit):
        law = sim.laws.tethering(hit.i, hit.j)
        return collision_impulse(hit.frame, hit.m_i, hit.m_j, law["c_retract"])


@lie("impulse", "chain chain_grouped gas", minimal=True)
class RevolvesForRetract(Impulse):
    kind = "retract"

    def instead(self, sim, hit):
        law = sim.laws.tethering(hit.i, hit.j)
        if not retraction_suffices(hit.frame, law["c_retract"] * 0.9, law["theta_revolve_deg"]) or norm(hit.frame.across) == 0:
            return None
        hit.kind = "revolve"
        return revolution_impulse(hit.frame, hit.m_i, hit.m_j, law["c_revolve"], law["theta_revolve_deg"])


@lie("impulse", ALL, minimal=True)
class AxisTurned(Impulse):
    """By a millionth of a radian."""

    least = 1

    def instead(self, sim, hit):
        return plus(hit.dp, hit.frame.across, 1e-6 * norm(hit.dp) / max(norm(hit.frame.across), 1e-3))


@lie("impulse", GROUPED, minimal=True)
class ParticleMassForBody(Impulse):
    """A member of a group collides with its own mass."""

    limit = INNER

    def instead(self, sim, hit):
        c = sim.laws.blocking(hit.i, hit.j)["c_rebound"]
        return collision_impulse(hit.frame, sim.mass[hit.i], sim.mass[hit.j], c)


@lie("impulse", ALL, minimal=True)
class NoImpulse(Impulse):
    """An approaching pair passes on."""

    limit = INNER

    def instead(self, sim, hit):
        hit.answered = False
        return tuple(0.0 for _ in hit.dp)


@lie("impulse", "gas chain", minimal=True)
class OnlyOneSide(Impulse):
    """Only i is pushed."""

    limit = INNER

    def instead(self, sim, hit):
        self.hit = hit
        return times(1 + 1e-6, hit.dp)

    def applied(self, sim, hit, new):
        if self.told == 1 and hit is self.hit:
            return new[0], sim.v[hit.j]
        return new

    least = 0


class Velocity(Lie):
    """Velocities after that do not follow from Δp."""

    def applied(self, sim, hit, new):
        if not self.now(sim) or hit.limit != INNER or any(sim.fixed[k] for k in (hit.i, hit.j)):
            return new
        self.tell()
        return self.instead(sim, hit, new)


@lie("impulse", "gas chain", minimal=True)
class SidesSwapped(Velocity):
    """−Δp on A, Δp on B."""

    def instead(self, sim, hit, new):
        return plus(sim.v[hit.i], hit.dp, -1 / hit.m_i), plus(sim.v[hit.j], hit.dp, 1 / hit.m_j)


@lie("impulse", "gas", minimal=True)
class MassesSwapped(Velocity):
    def applied(self, sim, hit, new):
        return super().applied(sim, hit, new) if hit.m_i != hit.m_j else new

    def instead(self, sim, hit, new):
        return plus(sim.v[hit.i], hit.dp, 1 / hit.m_j), plus(sim.v[hit.j], hit.dp, -1 / hit.m_i)


@lie("impulse conservation", "gas chain")
class EnergyInjected(Velocity):
    """Both speeds grow by 1e-12."""

    def instead(self, sim, hit, new):
        return tuple(times(1 + 1e-12, v) for v in new)


@lie("impulse conservation", "gas chain")
class OneVelocityOff(Velocity):
    """By eight ulps of its largest component."""

    def instead(self, sim, hit, new):
        k = max(range(len(new[0])), key=lambda n: abs(new[0][n]))
        return tuple(next_after(x, 8) if n == k else x for n, x in enumerate(new[0])), new[1]


@lie("bounds contact creep impulse earliest", "dead")
class Creep(Velocity):
    """A resting contact is left with an approach of two roundings, and creeps through its limit."""

    def __init__(self, first):
        super().__init__(0)

    def applied(self, sim, hit, new):
        self.tell()
        return new[0], plus(new[1], sim.v[hit.j], 2 * UNIT)
