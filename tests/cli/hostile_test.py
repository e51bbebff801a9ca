"""Programs and libraries that crash, hang, flood, fork and hide: each is told from the others, exit code 4, and nothing of
it is left. Arguments: the program, the folder with hostile_library.so, [--only MODE]."""
import concurrent.futures
import os
import re
import sys
import tempfile

import hostile_program
import processes

HUNG = r"hung: no reply within 1500 ms"
# What each mode is called: the exit code and a pattern. Modes that answer too early or too much are some kind of garbage.
PROGRAMS = {
    "exit_at_once": (4, r"ended with exit code 3"),
    "crash_at_once": (4, r"crashed: signal 11"),
    "flood_before_hello": (4, r"garbage: a line without an end"),
    "flood_lines_before_hello": (4, r"the answer to hello has no name"),
    "hello_nonsense": (4, r"the answer to hello"),
    "hello_huge_bits": (4, r"bits = 1e\+?300; allowed are integers from 8 to 400"),
    "hello_no_bits": (4, r"bits = 0; allowed are integers from 8 to 400"),
    "hello_bits_in_words": (4, r'bits = "many"; allowed are integers'),
    "crash": (4, r"crashed: signal 11"),
    "abort": (4, r"crashed: signal 6"),
    "exit": (4, r"ended with exit code 7"),
    "exit_0": (4, r"ended with exit code 0"),
    "hang": (4, HUNG),
    "partial": (4, HUNG),
    "partial_exit": (4, r"ended with exit code 0 in the middle of a line"),
    "drip": (4, HUNG),
    "deaf": (4, HUNG),
    "stopped": (4, HUNG),
    "close_stdin": (4, HUNG),
    "close_stdout": (4, r"closed its output"),
    "close_both": (4, r"closed its output"),
    "fork_crash": (4, r"crashed: signal 11"),
    "fork_exit": (4, r"ended with exit code 5"),
    "fork_hang": (4, HUNG),
    "session_crash": (4, r"crashed: signal 11"),
    "session_hang": (4, HUNG),
    "daemon_exit": (4, r"ended with exit code 0"),
    "daemon_hang": (4, HUNG),
    "grandchildren": (4, HUNG),
    "kill_parent": (4, HUNG),
    "kill_parent_outright": (4, r"ended, and its guard with it"),
    "kill_the_group": (4, r"crashed: signal 9"),
    "not_json": (4, r"garbage"),
    "nul": (4, r"garbage"),
    "nul_after": (4, r"garbage"),
    "not_utf8": (4, r"."),
    "escapes": (4, r"garbage"),
    "wrong_seq": (4, r"seq \d+ was asked, 99999 answered"),
    "deep": (4, r"."),
    "null": (4, r"garbage"),
    "empty": (4, r"garbage"),
    "empty_out": (4, r"has no dp"),
    "nan": (4, r"no hexadecimal float"),
    "flood": (4, r"garbage: a line without an end"),
    "flood_lines": (4, r"."),
    "flood_stderr": (4, HUNG + r"; its last words on standard error: EEE"),
    "noisy": (1, r"BROKEN"),  # a zero impulse turns nothing round
    "crlf": (1, r"BROKEN"),
    "right": (1, r"BROKEN"),
}

LIBRARIES = {
    "segv": (4, r"crashed: signal 11"),
    "null": (4, r"crashed: signal"),
    "abort": (4, r"crashed: signal 6"),
    "exit": (4, r"ended with exit code 0"),
    "_exit": (4, r"ended with exit code 9"),
    "hang": (4, r"hung: no reply within 300 ms"),  # it spins: a longer wait is processor time and tells no more
    "sleep": (4, HUNG),
    "recursion": (4, r"crashed: signal"),
    "stop": (4, HUNG),
    "fork_crash": (4, r"crashed: signal 11"),
    "session_hang": (4, HUNG),
    "kill_parent": (1, r"BROKEN"),
    "prints": (1, r"BROKEN"),
    "fakes_a_reply": (1, r"BROKEN"),
    "closes": (1, r"BROKEN"),
    "changes_folder": (1, r"BROKEN"),
    "floods_errors": (1, r"BROKEN"),
    "nan": (4, r"no hexadecimal float"),
    "constructor_crash": (4, r"crashed: signal 11"),
    "constructor_exit": (4, r"ended with exit code 0"),
    "constructor_prints": (1, r"BROKEN"),
    "no_table": (4, r"returned a null pointer|has no name"),
    "wild_table": (4, r"crashed: signal"),
    "odd_table": (4, r"returned 0x1, where no table can be"),
    "other_version": (4, r"version"),
    "no_name": (4, r"without a name|has no name"),
    "no_bits": (4, r"allowed are integers from 8 to 400"),
    "wild_function": (4, r"crashed: signal"),
    "": (1, r"BROKEN"),
}


AT_A_TIME = 16


def tried(case):
    """What is expected of a case, and whether it holds."""
    name, words, environment, (code, pattern) = case
    with tempfile.TemporaryDirectory() as scratch:
        try:
            seen, out, err = processes.run(words, environment=environment, cwd=scratch)
        except AssertionError as error:
            return [(False, f"{name}: {error}")]
    text = out + err
    return [(seen == code, f"{name}: exit code {seen}, not {code}: {text[-600:]}"),
            (re.search(pattern, text) is not None, f"{name}: '{pattern}' is not in {text[-600:]}")]


def main():
    tps, folder = (os.path.abspath(path) for path in sys.argv[1:3])
    only = sys.argv[4] if len(sys.argv) > 4 else None
    failures = processes.Failures()
    failures.expect(set(PROGRAMS) == set(hostile_program.MODES), "every mode of hostile_program.py is tried")

    def asked(timeout):
        return [tps, "properties", "--quiet", "--law", "Eq4Laws.Law1*", "--cases", "3", "--timeout", timeout, "-o", "-"]

    cases = [(f"program {mode}", asked("1.5") + ["--", sys.executable, hostile_program.__file__, mode], {}, expected)
             for mode, expected in PROGRAMS.items()]
    cases += [(f"library {mode}", asked("0.3" if mode == "hang" else "1.5") + ["--library", f"{folder}/hostile_library.so"], {"HOSTILE": mode}, expected)
              for mode, expected in LIBRARIES.items()]
    cases = [case for case in cases if only in (None, case[0].split()[-1])]
    # Hardly any of them computes: they wait side by side.
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        for findings in pool.map(tried, cases):
            for holds, what in findings:
                failures.expect(holds, what)
    return failures.conclude("hostile programs and libraries, nothing left of any")


if __name__ == "__main__":
    sys.exit(main())
