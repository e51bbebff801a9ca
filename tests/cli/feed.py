"""Feeds every file of some folders to every verb that reads one: each call ends soon, in little memory, with a documented exit
code and a message that can be printed. Prints what each file gets; *.gz is unpacked first.

feed.py PROGRAM FOLDER… [--brief]   (--brief prints only the sum)
"""
import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time

import processes
from printed_test import UNPRINTABLE

VERBS = ["run {} -q --max-events 1000", "run --resume {} -q --max-events 1000 -o made", "explain {}", "check {} -q", "check {} -q --format json", "draw {} -o made",
         "import {}", "eval load --in {}", "vectors verify {}", "vectors requests {}", "vectors verify known --answers {}", "properties --quiet --replay {}", "serve"]
DOCUMENTED = (0, 1, 2, 3, 4, 5, 6, 7, 8)
MOST_SECONDS, MOST_MEGABYTES = 30, 1500


def measured(words, folder, given):
    """(exit code, output, seconds, megabytes at most)"""
    start = time.monotonic()
    with open(given, "rb") as stdin, tempfile.TemporaryFile() as out:
        process = subprocess.Popen(words, cwd=folder, stdin=stdin, stdout=out, stderr=subprocess.STDOUT)
        timer = threading.Timer(MOST_SECONDS, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        text = out.read(1 << 22).decode(errors="replace")
    return process.returncode, text, time.monotonic() - start, usage.ru_maxrss / 1024


def message_of(text):
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith(("{", "<", "scene "))]
    return re.sub(r"\s+", " ", lines[0])[:110] if lines else ""


def main():
    tps = os.path.abspath(sys.argv[1])
    folders = [pathlib.Path(word) for word in sys.argv[2:] if not word.startswith("--")]
    brief = "--brief" in sys.argv
    failures = processes.Failures()
    slowest = largest = (0, "")
    files = sorted(path for folder in folders for path in folder.rglob("*") if path.is_file())
    for path in files:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            subprocess.run([tps, "vectors", "generate", "--op", "load", "--stratum", "plain", "--level", "1", "-o", "."], cwd=folder, check=True)
            (folder / "load.plain.jsonl").rename(folder / "known")
            name = path.name.removesuffix(".gz")
            # Not held in memory: the size of a process begins at that of its parent.
            with (gzip.open if path.suffix == ".gz" else open)(path, "rb") as source, open(folder / "original", "wb") as target:
                shutil.copyfileobj(source, target)
            if not brief:
                print(f"{path.name} ({(folder / 'original').stat().st_size} bytes)")
            for verb in VERBS:
                shutil.copy(folder / "original", folder / name)  # a run that is gone on with writes
                words = [word.format(name) for word in verb.split()]
                code, text, seconds, megabytes = measured([tps, *words], folder, folder / name)
                what = f"{path.name}, {verb.format('FILE')}"
                failures.expect(code in DOCUMENTED and seconds < MOST_SECONDS, f"{what}: exit code {code} after {seconds:.1f} s")
                failures.expect(megabytes < MOST_MEGABYTES, f"{what}: {megabytes:.0f} MB")
                failures.expect(not UNPRINTABLE.search(text), f"{what}: {ascii(text[:300])}")
                slowest, largest = max(slowest, (seconds, what)), max(largest, (megabytes, what))
                if not brief:
                    print(f"  {code}  {seconds:5.2f} s {megabytes:5.0f} MB  {verb.format('FILE'):52} {message_of(text)}")
    print(f"slowest: {slowest[0]:.2f} s, {slowest[1]}; largest: {largest[0]:.0f} MB, {largest[1]}")
    return failures.conclude(f"{len(files)} files fed to {len(VERBS)} verbs")


if __name__ == "__main__":
    sys.exit(main())
