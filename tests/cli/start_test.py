"""What a start of the program takes along: Arb is loaded by the commands that need it and by no other, and a command that
cannot load it says so. Argument: the program."""
import os
import pathlib
import sys
import tempfile

import processes

ASKED = b'{"seq":1,"op":"revolution_impulse","in":{"m_A":1,"m_B":2,"u_A":[0,0],"u_B":[1,0],"v_A":[0,0],"v_B":[0,1],"c_revolve":0.5,"theta_revolve_deg":30}}\n'


def loaded(tps, words, given=None):
    """The shared libraries that a call loads, as the dynamic linker tells."""
    code, out, err = processes.run([tps, *words], environment={"LD_DEBUG": "files"}, input=given)
    return code, out, {pathlib.Path(line.split("calling init: ")[1].strip()).name.split(".so")[0] for line in err.splitlines() if "calling init: " in line}


def main():
    tps = os.path.abspath(sys.argv[1])
    failures = processes.Failures()
    for words in (["--version"], ["--help"], ["eval", "load", "m_A=1", "m_B=2", "v_A=1,0", "v_B=0,0"]):
        code, _, libraries = loaded(tps, words)
        failures.expect(code == 0 and "libstdc++" in libraries, f"{words}: {code}, {libraries}")
        failures.expect(not any("flint" in name or "arb" in name for name in libraries), f"{words} loads {libraries}")
    code, answer, libraries = loaded(tps, ["serve"], ASKED)
    failures.expect(code == 0 and '"dp"' in answer and any("flint" in name for name in libraries), f"serve: {code}, {answer}, {libraries}")
    with tempfile.TemporaryDirectory() as folder:
        for name in (name for name in libraries if "flint" in name or "arb" in name):
            for version in range(30):
                (pathlib.Path(folder) / f"{name}.so.{version}").write_text("no library")
        for words in (["serve"], ["vectors", "generate", "--op", "revolution_impulse", "--level", "1", "-o", folder]):
            code, _, err = processes.run([tps, *words], environment={"LD_LIBRARY_PATH": folder}, input=ASKED)
            failures.expect(code == 4 and "cannot load Arb" in err and "install it" in err and "internal" not in err, f"{words} without Arb: {code}, {err}")
    return failures.conclude("what a start takes along")


if __name__ == "__main__":
    sys.exit(main())
