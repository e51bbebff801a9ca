"""The program of the first `./run`: it runs and checks in double like the whole one, and says of everything else what to build.
Arguments: the whole program, that of the first build, a scene."""
import os
import sys
import tempfile

import processes

BUILD = "./run build builds the rest"


def main():
    whole, first = (os.path.abspath(program) for program in sys.argv[1:3])
    scene = sys.argv[3]
    failures = processes.Failures()

    def said(program, *words):
        code, out, err = processes.run([program, *words])
        return code, out, err

    with tempfile.TemporaryDirectory() as folder:
        traces = {}
        for name, program in (("whole", whole), ("first", first)):
            trace = os.path.join(folder, name + ".ndjson")
            code, _, err = said(program, "run", scene, "--max-events", "50", "-o", trace)
            failures.expect(code == 0, f"{name}: {err}")
            with open(trace, "rb") as written:
                traces[name] = written.read()
            code, _, err = said(first, "check", trace)
            failures.expect(code == 0, f"check of the trace of the {name} program: {err}")
        failures.expect(traces["whole"] == traces["first"], "the two programs write different traces")

        lacking = [["eval", "load"], ["vectors", "list"], ["check", os.path.join(folder, "first.ndjson"), "--witness", "-"]]
        for scalar in ("float", "long-double", "quad", "mp50", "mp100"):
            lacking.append(["run", scene, "--scalar", scalar, "-o", os.path.join(folder, "none.ndjson")])
            trace = os.path.join(folder, scalar + ".ndjson")
            code, _, err = said(whole, "run", scene, "--scalar", scalar, "--timing", "stable", "--max-events", "5", "-o", trace)
            failures.expect(code == 0, f"{scalar}: {err}")
            if scalar != "float":
                lacking.append(["check", trace])
        code, _, err = said(first, "check", os.path.join(folder, "float.ndjson"))
        failures.expect(code == 0, f"check of a trace in float: {err}")
        for words in lacking:
            code, out, err = said(first, *words)
            failures.expect(code == 2 and BUILD in err and not out, f"{words}: exit code {code}, {out[:200]}{err}")
        failures.expect(not os.path.exists(os.path.join(folder, "none.ndjson")), "a trace was begun that cannot be written")
    return failures.conclude("the program of the first build")


if __name__ == "__main__":
    sys.exit(main())
