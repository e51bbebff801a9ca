"""Every operation but next_event: python3 scalar.py, asked by `tps conform -- python3 data/adapters/python/scalar.py`."""
import effects
import groups
import responses
import timing
from protocol import serve

serve("Python", {**timing.OPERATIONS, **responses.OPERATIONS, **groups.OPERATIONS, **effects.OPERATIONS})
