"""What the tests of processes share: starting them, waiting for what they do, and looking for what they left."""
import ctypes
import itertools
import os
import pathlib
import signal
import subprocess
import time

GENEROUS = 60.0  # seconds for what takes milliseconds: tests wait for conditions, not for clocks
_numbers = itertools.count()


def wait_until(condition, what, limit=GENEROUS):
    end, pause = time.monotonic() + limit, 0.002
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"{limit:.0f} s passed, and still not: {what}")
        time.sleep(pause)
        pause = min(1.5 * pause, 0.05)  # asking is processor time


def adopt_orphans():
    """From here on what a call leaves behind becomes a child of this process (prctl(2), PR_SET_CHILD_SUBREAPER), so that one
    question tells whether there is any; without it every process of the machine is asked for its mark."""
    Marked.orphans_are_ours = ctypes.CDLL(None).prctl(36, 1, 0, 0, 0) == 0


def has_children():
    try:
        os.waitid(os.P_ALL, 0, os.WEXITED | os.WNOHANG | os.WNOWAIT)
    except ChildProcessError:
        return False
    return True


class Marked:
    """A process whose descendants can be found by a mark in their environment, whoever their parent is."""

    orphans_are_ours = False

    def __init__(self, words, environment=None, **options):
        key, value = "TPS_TEST_MARK", f"m{os.getpid()}x{next(_numbers)}x"
        self.mark = f"{key}={value}".encode()
        options.setdefault("stdin", subprocess.DEVNULL)
        options.setdefault("stdout", subprocess.PIPE)
        options.setdefault("stderr", subprocess.PIPE)
        self.words = [str(word) for word in words]
        self.process = subprocess.Popen(self.words, env=dict(os.environ, **{key: value}, **(environment or {})), **options)

    def left(self):
        """Processes with the mark that still run; a zombie does not."""
        found = []
        for name in os.listdir("/proc"):
            if not name.isdigit() or int(name) == self.process.pid:
                continue
            try:
                with open(f"/proc/{name}/environ", "rb", buffering=0) as environment:
                    if self.mark not in environment.readall():
                        continue
                if pathlib.Path(f"/proc/{name}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z":
                    found.append(int(name))
            except (OSError, IndexError):
                continue  # it has just ended
        return found

    def require_none_left(self):
        """They are killed as the process ends; that takes the system a moment."""
        if self.orphans_are_ours and not has_children():
            return
        try:
            wait_until(lambda: not self.left(), f"no process of {self.words} is left", 20)
        finally:
            for process in self.left():
                os.kill(process, signal.SIGKILL)

    def end(self, limit=GENEROUS):
        """(exit code, standard output, standard error) as text; ends it, loudly, where it does not."""
        try:
            out, err = self.process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            raise AssertionError(f"{self.words} did not end within {limit:.0f} s") from None
        finally:
            self.require_none_left()
        return self.process.returncode, (out or b"").decode(errors="replace"), (err or b"").decode(errors="replace")

    def status(self, key):
        try:
            for line in pathlib.Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
                if line.startswith(key + ":"):
                    return line.split(":", 1)[1].split()
        except OSError:
            pass
        return [""]

    def listens(self):
        """It has installed what it does at SIGINT."""
        mask = self.status("SigCgt")[0]
        return mask != "" and int(mask, 16) >> (signal.SIGINT - 1) & 1 == 1

    def sleeps(self):
        return self.status("State")[0] == "S"

    def cpu_seconds(self):
        try:
            fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
            return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
        except (OSError, IndexError):
            return 0.0


def run(words, limit=GENEROUS, environment=None, **options):
    given = options.pop("input", None)
    if given is not None:
        options["stdin"] = subprocess.PIPE
    marked = Marked(words, environment, **options)
    if given is not None:
        try:
            marked.process.stdin.write(given)
            marked.process.stdin.close()
        except BrokenPipeError:
            pass
        marked.process.stdin = None
    return marked.end(limit)


class Failures:
    """Counts what held, and shows what did not."""

    def __init__(self):
        self.held, self.broken = 0, []

    def expect(self, holds, what):
        if holds:
            self.held += 1
        else:
            self.broken.append(what)
            print("WRONG:", what, flush=True)

    def conclude(self, name):
        print(f"{name}: {self.held} hold, {len(self.broken)} do not")
        return 1 if self.broken or not self.held else 0
