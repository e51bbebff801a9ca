"""Descriptors that are closed, outputs that are something else of the same call, and two writers of one file.
Argument: the program."""
import fcntl
import itertools
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import processes

USAGE, BAD_INPUT, OUTPUT_FAILED = 2, 3, 7


def make_files(tps, folder):
    """One of each kind of file that a verb reads."""
    subprocess.run([tps, "scene", "pair", "-o", "scene"], cwd=folder, check=True)
    subprocess.run([tps, "run", "scene", "-q", "-o", "trace", "--checkpoint", "checkpoint"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    subprocess.run([tps, "vectors", "generate", "--op", "load", "--level", "1", "-o", "vectors"], cwd=folder, check=True)
    (folder / "input").write_text('{"m_A":1,"m_B":2,"v_A":[1,0],"v_B":[0,0]}')
    (folder / "scenario").write_text("{}")
    (folder / "regressions").write_text("")
    (folder / "profile").write_text('{"conform_profile":1,"name":"mine","fails":["WRONG"]}')


def aliases(folder, name):
    """Other names of a file, there or not yet."""
    path = folder / name
    yield name
    yield f"./{name}"
    yield str(path)
    yield f"../{folder.name}/{name}"
    for kind, make in (("soft", lambda link: link.symlink_to(name)), ("soft_soft", lambda link: link.symlink_to(f"soft_{name}")),
                       ("far", lambda link: link.symlink_to(path))):
        link = folder / f"{kind}_{name}"
        if not link.is_symlink():
            make(link)
        yield link.name
    if path.exists():
        hard = folder / f"hard_{name}"
        if not hard.exists():
            os.link(path, hard)
        yield hard.name
    if not (folder / "folder_link").is_symlink():
        (folder / "folder_link").symlink_to(".")
    yield f"folder_link/{name}"


# The verbs that write files, by what they read and write: {} is a file, {a}, {b} two that must differ.
PAIRS = [
    ("run {a} -q -o {b}", "scene"),
    ("run {a} -q --checkpoint {b}", "scene"),
    ("run scene -q -o {a} --checkpoint {b}", "new"),
    ("run scene -q -o {a} --checkpoint {b}", "trace"),
    ("run --resume checkpoint -q -o {a} --checkpoint {b}", "trace"),
    ("run --resume {a} -q -o {b}", "checkpoint"),
    ("run --resume {a} -q --checkpoint {b}", "trace"),
    ("run --resume trace -q -o {a} --checkpoint {b}", "new"),
    ("check {a} -o {b}", "trace"),
    ("check {a} --witness {b}", "trace"),
    ("check {a} --view {b}", "trace"),
    ("view {a} -o {b}", "trace"),
    ("check trace --scene {a} -o {b}", "scene"),
    ("check trace --scene {a} --witness {b}", "scene"),
    ("check trace -o {a} --witness {b}", "new"),
    ("draw {a} -o {b}", "trace"),
    ("draw {a} -o {b}", "scene"),
    ("draw {a} -o {b}", "checkpoint"),
    ("import {a} -o {b}", "scenario"),
    ("properties --quiet --cases 1 --law Eq6Laws.Law1* -o {a} --regressions {b}", "new"),
    ("properties --quiet --cases 1 --law Eq6Laws.Law1* -o {a} --regressions {b}", "regressions"),
    ("conform --quiet --level 1 --tags load.plain --scalar double --profile {a} --report {b}", "profile"),
    ("conform --quiet --level 1 --tags load.plain --scalar double --expect-fail {a} --report {b}", "regressions"),
]
# Verbs that read a file and print: the file must not be where standard output goes.
PRINTED = [("explain {a}", "scene"), ("draw {a}", "trace"), ("check {a}", "trace"), ("run {a} -q", "scene"), ("eval load --in {a}", "input"),
           ("vectors verify {a}", "vectors/"), ("vectors requests {a}", "vectors/"),
           ("properties --quiet --replay {a}", "regressions"), ("run --resume {a} -q", "trace")]
# What is the same on purpose.
ALLOWED = ["run --resume {a} -q -o {b}", "run --resume {a} -q"]


def words_of(text, **names):
    return [word.format(**names) for word in text.split()]


def contents(folder):
    return {path.relative_to(folder): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def refuse_shared_files(tps, failures):
    for text, name in PAIRS:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            make_files(tps, folder)
            names = list(aliases(folder, name))
            before = contents(folder)
            for a, b in itertools.islice(itertools.product(names, names), 0, None, 3):
                words = words_of(text, a=a, b=b)
                code, out, err = processes.run([tps, *words], cwd=scratch)
                failures.expect(code == USAGE and "are one file" in err, f"{' '.join(words)}: {code}, {err}")
                if contents(folder) != before:
                    failures.expect(False, f"{' '.join(words)}: a file was touched before it was refused")
                    break
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        make_files(tps, folder)
        before = contents(folder)
        for text, name in PRINTED:
            if name == "vectors/":
                name = str(next((folder / "vectors").iterdir()).relative_to(folder))
            with open(folder / name, "ab") as end:
                words = words_of(text, a=name)
                code, _, err = processes.run([tps, *words], cwd=scratch, stdout=end)
            failures.expect(code == USAGE and contents(folder) == before, f"{' '.join(words)} >> {name}: {code}, {err}")
        for text in ALLOWED:
            names = list(aliases(folder, "trace"))
            before = contents(folder)
            for a, b in itertools.islice(itertools.product(names, repeat=2), 0, None, 4):
                words = words_of(text, a=a, b=b)
                code, _, err = processes.run([tps, *words], cwd=scratch)
                failures.expect(code == 0 and contents(folder) == before, f"{' '.join(words)}: {code}, {err}")
        for text, name in (("run - -q -o {a}", "scene"), ("check - -o {a}", "trace"), ("import - -o {a}", "scenario"), ("check - --witness {a}", "trace")):
            for a in aliases(folder, name):
                before = contents(folder)
                with open(folder / name, "rb") as given:
                    code, _, err = processes.run([tps, *words_of(text, a=a)], cwd=scratch, stdin=given)
                failures.expect(code == USAGE and contents(folder) == before, f"{text} < {name}: {code}, {err}")
        for text in ("run scene -q -o made", "check trace -o made", "check trace --witness made", "draw trace -o made"):
            for stream in ("stdout", "stderr"):
                with open(folder / "made", "wb") as end:
                    code, _, err = processes.run([tps, *text.split()], cwd=scratch, **{stream: end})
                failures.expect(code == USAGE and (stream == "stderr" or not (folder / "made").read_bytes()), f"{text}, and made as its {stream}: {code}, {err}")
        (folder / "made").unlink()
        code, _, err = processes.run([tps, "run", "scene", "-q", "-o", "/dev/null"], cwd=scratch)
        failures.expect(code == 0, f"-o /dev/null: {code}, {err}")
        code, _, err = processes.run([tps, "run", "scene", "-q", "--checkpoint", "/dev/null"], cwd=scratch)
        failures.expect(code == OUTPUT_FAILED and not pathlib.Path("/dev/null").is_file(), f"--checkpoint /dev/null: {code}, {err}")
        code, _, err = processes.run([tps, "run", "--resume", "checkpoint", "-q", "--checkpoint", "checkpoint"], cwd=scratch)
        failures.expect(code == 0, f"a checkpoint that goes on: {code}, {err}")
        # Two files of a folder that are one: the second would be written over the first.
        first, second = sorted((folder / "vectors").iterdir())[:2]
        second.unlink()
        second.symlink_to(first.name)
        before = contents(folder)
        code, _, err = processes.run([tps, "vectors", "generate", "--op", "load", "--level", "1", "-o", "vectors"], cwd=scratch)
        failures.expect(code == USAGE and contents(folder) == before, f"vectors generate into linked files: {code}, {err}")


def closed(words, descriptors, scratch):
    """A shell closes them; Python would not."""
    command = 'exec "$@" ' + " ".join(f"{d}{'<' if d == 0 else '>'}&-" for d in descriptors)
    return processes.run(["sh", "-c", command, "sh", *words], cwd=scratch)


def survive_closed_descriptors(tps, failures):
    printing = ["explain scene", "draw trace", "check trace", "run scene -q", "run scene -q -o made", "eval load --in input", "scene pair", "vectors list",
                "vectors verify vectors_file", "vectors requests vectors_file", "vectors generate --op load --level 1", "properties --list",
                "properties --quiet --cases 20 --law Eq6Laws.Law1*", "claims collisions", "--help", "run --help", "--version", "run scene -q -o -"]
    silent = ["scene pair -o made", "draw trace -o made", "check trace -o made", "vectors generate --op load --level 1 -o made_folder"]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        make_files(tps, folder)
        shutil.copy(next((folder / "vectors").iterdir()), folder / "vectors_file")
        whole = (folder / "trace").read_bytes()
        for text in printing:
            for descriptors in ([1], [0, 1], [1, 2], [0, 1, 2]):
                code, _, err = closed([tps, *text.split()], descriptors, scratch)
                failures.expect(code == OUTPUT_FAILED, f"{text} without {descriptors}: {code}, {err}")
            for descriptors in ([2], [0], [0, 2]):
                code, out, err = closed([tps, *text.split()], descriptors, scratch)
                failures.expect(code == 0, f"{text} without {descriptors}: {code}, {err}")
            with open("/dev/full", "wb") as full:
                code, _, err = processes.run([tps, *text.split()], cwd=scratch, stdout=full)
                failures.expect(code == OUTPUT_FAILED, f"{text} > /dev/full: {code}, {err}")
                code, _, _ = processes.run([tps, *text.split()], cwd=scratch, stderr=full)
                failures.expect(code == 0, f"{text} 2> /dev/full: {code}")
            if (folder / "made").exists():
                failures.expect((folder / "made").read_bytes() == whole, f"{text}: only the trace is in the trace")
        for text in silent:
            for descriptors in ([0], [1], [2], [0, 1], [0, 2], [1, 2], [0, 1, 2]):
                code, _, err = closed([tps, *text.split()], descriptors, scratch)
                failures.expect(code == 0, f"{text} without {descriptors}: {code}, {err}")
        for text in ("run -", "explain -", "check -", "serve", "eval load --in -", "vectors verify -", "import -"):
            for descriptors in ([0], [0, 2]):
                code, _, err = closed([tps, *text.split()], descriptors, scratch)
                failures.expect(code == BAD_INPUT or (code == 1 and "vectors" in text), f"{text} without {descriptors}: {code}, {err}")


def exclude_two_writers(tps, failures):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        make_files(tps, folder)
        subprocess.run([tps, "scene", "gas", "--particles", "100", "--duration", "1e6", "-o", "long"], cwd=scratch, check=True)
        for options, name in ((["-o", "shared"], "shared"), (["--checkpoint", "shared"], "shared"), (["-o", "other", "--checkpoint", "shared"], "shared")):
            first = processes.Marked([tps, "run", "long", "-q", "--state-every", "100", *options], cwd=scratch)
            processes.wait_until(lambda: (folder / name).exists() and (folder / name).stat().st_size > 0, "the first writer writes")
            link = folder / f"link_{name}"
            if not link.is_symlink():
                link.symlink_to(name)
            option = "-o" if options[-2] == "-o" else "--checkpoint"
            seconds = [["run", "scene", "-q", option, name], ["run", "scene", "-q", option, f"./{name}"], ["run", "scene", "-q", option, link.name]]
            if option == "-o":
                seconds += [["scene", "pair", "-o", name], ["draw", "trace", "-o", name], ["check", "trace", "-o", name], ["run", "--resume", name, "-q"]]
            for words in seconds:
                code, _, err = processes.run([tps, *words], cwd=scratch)
                failures.expect(code == OUTPUT_FAILED and "another process" in err, f"{' '.join(words)} beside a writer: {code}, {err}")
            first.process.send_signal(signal.SIGINT)
            code, _, err = first.end()
            failures.expect(code == 130, f"the first writer: {code}, {err}")
            code, _, err = processes.run([tps, "run", "scene", "-q", option, name], cwd=scratch)
            failures.expect(code == 0, f"afterwards: {code}, {err}")
            (folder / name).unlink()


def refuse_to_go_on_in_a_file_before_it_is_read(tps, failures):
    """What is written to meanwhile may grow faster than it is read: here the reader would find no full state."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        make_files(tps, folder)
        head = (folder / "trace").read_text().splitlines()[0]
        (folder / "begun").write_text(head + "\n")
        with open(folder / "begun", "a") as writer:
            fcntl.flock(writer, fcntl.LOCK_EX)
            code, _, err = processes.run([tps, "run", "--resume", "begun", "-q"], cwd=scratch)
        failures.expect(code == OUTPUT_FAILED and "another process" in err, f"resuming what another writes: {code}, {err}")
        code, _, err = processes.run([tps, "run", "--resume", "begun", "-q"], cwd=scratch)
        failures.expect(code == BAD_INPUT and "no full state" in err, f"afterwards: {code}, {err}")
        failures.expect((folder / "begun").read_text() == head + "\n", "what could not be taken up was changed")


def refuse_a_locked_output_before_the_start(tps, failures):
    """The start of a run can take minutes: its files are locked before it, and touched after it. A start that fails shows
    which comes first."""
    overflowing = {"tps": 1, "dimension": 2, "duration": 10, "species": {"a": {"mass": 1, "radius": 0.5}},
                   "pairs": [{"between": ["a", "a"], "blocking": {"c_rebound": 1}}],
                   "particles": [{"species": "a", "position": [0, 0], "velocity": [1e160, 0]}, {"species": "a", "position": [3, 0]}]}
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "scene").write_text(json.dumps(overflowing))
        (folder / "kept").write_text("of before")
        for option in ("-o", "--checkpoint"):
            words = [tps, "run", "scene", "-q", option, "kept"]
            code, _, err = processes.run(words, cwd=scratch)
            failures.expect(code == BAD_INPUT and (folder / "kept").read_text() == "of before", f"a start that fails leaves {option} as it was: {code}, {err}")
            with open(folder / "kept") as held:
                fcntl.flock(held, fcntl.LOCK_EX)
                code, _, err = processes.run(words, cwd=scratch)
            failures.expect(code == OUTPUT_FAILED and "another process" in err, f"{option} is locked before the start: {code}, {err}")
            code, _, err = processes.run([tps, "run", "scene", "-q", option, "made"], cwd=scratch)
            failures.expect(code == BAD_INPUT and not (folder / "made").exists(), f"a start that fails makes no {option}: {code}, {err}")


def read_a_scene_beside_a_trace_once(tps, failures):
    """It may come from a pipe."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        make_files(tps, folder)
        end = '{"end":"max_events","events":0,"t":0}\n'
        scene = json.loads((folder / "scene").read_text())
        (folder / "own").write_text(json.dumps({"trace": 1, "form": "minimal", "scene": scene}) + "\n" + end)
        (folder / "none").write_text('{"trace":1,"form":"minimal"}\n' + end)
        for verb, trace in itertools.product(("check", "view -o page"), ("own", "none")):
            command = f"cat scene | timeout 20 {tps} {verb} {trace} --scene /dev/stdin"
            code, _, err = processes.run(["sh", "-c", command], cwd=scratch)
            failures.expect(code == 0 and "not that of" not in err, f"{verb} {trace} with a scene from a pipe: {code}, {err}")


def main():
    tps = os.path.abspath(sys.argv[1])
    failures = processes.Failures()
    processes.adopt_orphans()
    refuse_shared_files(tps, failures)
    survive_closed_descriptors(tps, failures)
    exclude_two_writers(tps, failures)
    refuse_to_go_on_in_a_file_before_it_is_read(tps, failures)
    refuse_a_locked_output_before_the_start(tps, failures)
    read_a_scene_beside_a_trace_once(tps, failures)
    return failures.conclude("files of a call")


if __name__ == "__main__":
    sys.exit(main())
