"""What a lie (lie.py) may change of the simulator."""


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
