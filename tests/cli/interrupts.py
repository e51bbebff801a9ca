"""Ctrl-C and SIGTERM in every state in which a verb waits or computes: exit code 130, soon, and nothing left.
Arguments: the program, a program built with hostile_library.so's folder, [--each N] (signals a state, default 1).
The long form, 50 a state: python3 tests/cli/interrupts.py build/release/tps build/release/tests/cli --each 50"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import hostile_program
import processes

HOSTILE = [sys.executable, hostile_program.__file__]
LIMIT = processes.GENEROUS  # a busy machine; the long form reports what it took


class State:
    """Words of a command, and how one knows that it is there: it sleeps, or has computed a while."""

    def __init__(self, words, *, computes=False, stdin=False, blocked=False, trace=None, both=False, environment=None, feeds=b""):
        self.words, self.computes, self.stdin, self.blocked, self.trace = words.split(), computes, stdin, blocked, trace
        self.environment, self.feeds, self.both = environment, feeds, both


READING = ["run -", "explain -", "check -", "import -", "eval load --in -", "eval group --in -", "eval order --in -", "vectors verify -",
           "vectors requests -", "vectors verify vectors --answers -", "serve"]
OPENING = ["run fifo", "run --resume fifo", "explain fifo", "check fifo", "check trace --scene fifo", "draw fifo", "import fifo", "eval load --in fifo",
           "vectors verify fifo", "vectors requests fifo", "vectors verify vectors --answers fifo", "properties --replay fifo",
           "run scene -q -o fifo", "run long -q -o fifo", "scene pair -o fifo", "draw trace -o fifo", "check trace -o fifo",
           "properties --library ./fifo"]
STATES = ([State(words, stdin=True) for words in READING] + [State(words) for words in OPENING] + [
    State("serve", stdin=True, feeds=b'{"hello":1}\n'),
    State("check -", stdin=True, feeds=b'{"trace":1,'),
    State("run long -q -o -", blocked=True),
    State("scene gas --particles 20000 --density 0.1", blocked=True),
    State("vectors generate --level 3 --count 100000", blocked=True),
    State("vectors requests many", blocked=True),
    State("serve", stdin=True, feeds=b'{"hello":1}\n' * 4000, blocked=True),
    State("run long -q -o made --state-every 50", computes=True, trace="made"),
    State("run long -q --checkpoint made --state-every 50", computes=True, trace="made"),
    State("run long -q --scalar mp100 -o made --state-every 50", computes=True, trace="made"),
    State("run long -q --timing certified -o made --state-every 50", computes=True, trace="made"),
    State("run huge -q -o started", computes=True),
    State("explain huge", computes=True),
    State("check long_trace -q", computes=True),
    State("vectors generate --level 3 --count 100000 -o made_folder", computes=True),
    State("vectors verify many", computes=True),
    State("properties --quiet --minutes 5", computes=True),
    State("properties --quiet --minutes 5 --scalar mp100", computes=True),
    State("claims", computes=True),
    State("properties --quiet --timeout 3000 -- hostile hang"),
    State("properties --quiet --timeout 3000 -- hostile close_stdin"),
    State("properties --quiet --timeout 3000 -- hostile grandchildren"),
    State("properties --quiet --timeout 3000 -- hostile daemon_hang"),
    State("properties --quiet --timeout 3000 -- hostile deaf"),
    State("properties --quiet --timeout 3000 -- hostile flood_stderr"),
    State("properties --quiet --timeout 3000 -- sleep 1000"),
    State("properties --quiet --timeout 3000 --library ./hostile.so", environment={"HOSTILE": "hang"}),
    State("properties --quiet --timeout 3000 --library ./hostile.so", environment={"HOSTILE": "session_hang"}),
    State("properties --quiet --cases 100000 --timeout 3000 -- hostile crash", computes=True),
])


def make_files(tps, folder, libraries):
    def made(*words):
        subprocess.run([tps, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    made("scene", "pair", "-o", "scene")
    made("run", "scene", "-q", "-o", "trace")
    made("scene", "gas", "--particles", "100", "--duration", "1e6", "-o", "long")
    made("run", "long", "-q", "-o", "long_trace", "--max-events", "60000")
    made("scene", "gas", "--particles", "20000", "--density", "0.1", "-o", "huge")
    made("vectors", "generate", "--op", "load", "--stratum", "plain", "--level", "3", "--count", "3000", "-o", "folder")
    sizes = sorted((folder / "folder").iterdir(), key=lambda path: path.stat().st_size)
    (folder / "many").write_bytes(20 * sizes[-1].read_bytes())
    made("vectors", "generate", "--op", "load", "--level", "1", "-o", "few")
    (folder / "vectors").write_bytes(next((folder / "few").iterdir()).read_bytes())
    (folder / "hostile.so").symlink_to(pathlib.Path(libraries).resolve() / "hostile_library.so")
    os.mkfifo(folder / "fifo")


def interrupt(tps, state, folder, number, random_delay, failures):
    words = []
    for word in state.words:
        words += HOSTILE if word == "hostile" else [word]
    name = f"{' '.join(state.words)} {state.environment or ''} ({signal.Signals(number).name})"
    marked = processes.Marked([tps, *words], state.environment, cwd=folder, stdin=subprocess.PIPE if state.stdin else subprocess.DEVNULL)
    if state.feeds:
        os.set_blocking(marked.process.stdin.fileno(), False)
        try:
            marked.process.stdin.write(state.feeds)
            marked.process.stdin.flush()
        except BlockingIOError:
            pass
    processes.wait_until(marked.listens, f"{name} listens")
    if state.computes:
        processes.wait_until(lambda: marked.process.poll() is not None or marked.cpu_seconds() > 0.02 or len(marked.left()) > 1, f"{name} computes")
    else:
        processes.wait_until(lambda: marked.process.poll() is not None or marked.sleeps(), f"{name} waits")
    if "hostile" in state.words:
        processes.wait_until(lambda: marked.process.poll() is not None or marked.left(), f"{name} has a child")
    time.sleep(random_delay)  # any moment will do
    if marked.process.poll() is not None:
        failures.expect(False, f"{name} ended by itself: {marked.end()}")
        return 0.0
    start = time.monotonic()
    marked.process.send_signal(number)
    if state.blocked:  # the reader takes nothing until the end
        marked.process.wait(LIMIT)
    elif state.stdin:
        processes.wait_until(lambda: marked.process.poll() is not None, f"{name} ends")
    else:
        marked.process.wait(LIMIT)
    took = time.monotonic() - start
    if state.stdin:
        try:
            marked.process.stdin.close()
        except BrokenPipeError:
            pass
        marked.process.stdin = None
    code, out, err = marked.end(LIMIT)
    failures.expect(code == 130, f"{name}: {code}, {out[-300:]} {err[-300:]}")
    if state.trace:
        goes_on(tps, folder, state.trace, name, failures)
    return took


def goes_on(tps, folder, trace, name, failures):
    """What is written can be gone on from, or says that it holds nothing yet."""
    if not (folder / trace).exists():
        return
    words = [tps, "run", "--resume", trace, "-q", "-o", "resumed", "--max-events", "1"]
    if (folder / trace).read_bytes().startswith(b'{"checkpoint"'):
        words = words[:5] + words[7:]
    code, _, err = processes.run(words, cwd=folder)
    failures.expect(code == 0 or (code == 3 and ("no full state" in err or "no complete line" in err)), f"{name}, then resumed: {code}, {err}")


def main():
    tps = os.path.abspath(sys.argv[1])
    each = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    delays = random.Random(20261125)
    failures = processes.Failures()
    slowest = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        make_files(tps, folder, sys.argv[2])
        for state in STATES:
            took = []
            for n in range(each):
                for made in ("made", "started", "resumed"):
                    (folder / made).unlink(missing_ok=True)
                number = (signal.SIGINT, signal.SIGTERM)[n % 2] if each > 1 else delays.choice((signal.SIGINT, signal.SIGTERM))
                try:
                    took.append(interrupt(tps, state, folder, number, delays.random() * 0.05 * (n > 0), failures))
                except (AssertionError, subprocess.TimeoutExpired) as error:
                    failures.expect(False, f"{' '.join(state.words)}: {error}")
            slowest.append((max(took, default=0), " ".join(state.words)))
        # The second one ends at once what the first one would end in good order.
        for words in ("run long -q -o made", "check long_trace -q", "properties --quiet --minutes 5"):
            marked = processes.Marked([tps, *words.split()], cwd=folder)
            processes.wait_until(lambda: marked.listens() and marked.cpu_seconds() > 0.02, "it computes")
            marked.process.send_signal(signal.SIGTERM)
            marked.process.send_signal(signal.SIGINT)
            code, _, _ = marked.end()
            failures.expect(code == 130, f"{words}, twice interrupted: {code}")
    for seconds, name in sorted(slowest)[-3:]:
        print(f"slowest: {seconds:.2f} s {name}")
    return failures.conclude(f"interrupts in {len(STATES)} states, {each} each")


if __name__ == "__main__":
    sys.exit(main())
