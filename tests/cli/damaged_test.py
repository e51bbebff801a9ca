"""Traces that were damaged behind their run: `--resume` and `draw` take up no state that stands behind damage that shows, and
what their message advises leads to the trace of the run let alone. Argument: the program."""
import os
import pathlib
import re
import sys
import tempfile

import processes

BAD_INPUT = 3
EVENTS = 200


def flipped(text, place):
    """Another digit there."""
    return text[:place] + (b"2" if text[place:place + 1] == b"1" else b"1") + text[place + 1:]


def damages(lines):
    """(name, lines, number of the line to be named): every way in which a line between two states can be spoilt."""
    event = next(n for n, line in enumerate(lines) if n > len(lines) // 3 and line.startswith(b'{"k"'))
    state = next(n for n, line in enumerate(lines) if n > len(lines) // 3 and line.startswith(b'{"state"'))

    def put(n, *others):
        return lines[:n] + list(others) + lines[n + 1:]

    text = lines[event]
    yield "cut off", put(event, text[:len(text) // 2]), event
    yield "grown together", lines[:event] + [text[:40] + lines[event + 1]] + lines[event + 2:], event
    yield "zeroed", put(event, b"\0" * len(text)), event
    yield "empty", put(event, b""), event
    yield "lost", put(event), event
    yield "doubled", put(event, text, text), event + 1
    yield "garbage behind", put(event, text + b"x"), event
    yield "two objects", put(event, text + text), event
    yield "a bracket", put(event, text.replace(b"]", b"}", 1)), event
    yield "a control character", put(event, text[:-1] + b"\x1b}"), event
    yield "a list", put(event, b"[" + text + b"]"), event
    yield "of nothing", put(event, b'{"x":1}'), event
    yield "an end", put(event, b'{"end":"duration","events":1,"t":"0x0p+0"}'), event + 1
    yield "state lost a digit", put(state, flipped(lines[state], lines[state].index(b"0x1.", lines[state].index(b'"particles"')) + len(b"0x1."))), state
    yield "state is cut off", put(state, lines[state][:-30]), state
    yield "state of another event", put(state, re.sub(rb'"state":\d+', b'"state":7', lines[state])), state


def main():
    tps = os.path.abspath(sys.argv[1])
    failures = processes.Failures()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)

        def ran(*words):
            return processes.run([tps, *words], cwd=folder)

        ran("scene", "gas", "--particles", "12", "--duration", "1e6", "-o", "scene")
        ran("run", "scene", "-q", "-o", "whole", "--max-events", str(EVENTS), "--state-every", "20")
        whole = (folder / "whole").read_bytes()
        lines = whole.split(b"\n")[:-1]
        for name, spoilt, at in damages(lines):
            (folder / "spoilt").write_bytes(b"\n".join(spoilt) + b"\n")
            for words in (("run", "--resume", "spoilt", "-q", "--max-events", str(EVENTS)), ("draw", "spoilt", "-o", "picture")):
                code, _, err = ran(*words)
                failures.expect(code == BAD_INPUT and f"spoilt:{at + 1}:" in err, f"{name}, {words[0]}: {code}, {err[:300]}")
            failures.expect((folder / "spoilt").read_bytes() == b"\n".join(spoilt) + b"\n", f"{name}: what is refused is not touched")
            advice = re.search(r"head -n (\d+)", err)
            failures.expect(advice is not None, f"{name}: {err[:300]}")
            if advice:
                (folder / "spoilt").write_bytes(b"\n".join(spoilt[:int(advice[1])]) + b"\n")
                code, _, err = ran("run", "--resume", "spoilt", "-q", "--max-events", str(EVENTS))
                failures.expect(code == 0 and (folder / "spoilt").read_bytes() == whole, f"{name}, cut off and gone on: {code}, {err[:300]}")
        # What stands behind the last state is simulated again: damage there costs nothing.
        last = max(n for n, line in enumerate(lines) if line.startswith(b'{"state"') and b'"final"' not in line)
        for tail in (b"\0" * 5000, b'{"k":3', b"\n\n", b'{"k":999999}\n'):
            (folder / "spoilt").write_bytes(b"\n".join(lines[:last + 1]) + b"\n" + tail)
            code, _, err = ran("run", "--resume", "spoilt", "-q", "--max-events", str(EVENTS))
            failures.expect(code == 0 and (folder / "spoilt").read_bytes() == whole, f"behind the last state {tail[:20]}: {code}, {err[:300]}")
        # The same content, spelt with spaces, is no damage.
        spaced = [re.sub(rb'(["}\]])([:,])', rb"\1\2 ", line) for line in lines]
        (folder / "spaced").write_bytes(b"\n".join(spaced) + b"\n")
        code, _, err = ran("draw", "spaced", "-o", "picture")
        failures.expect(code == 0, f"spelt with spaces: {code}, {err[:300]}")
    return failures.conclude("damaged traces")


if __name__ == "__main__":
    sys.exit(main())
