#!/usr/bin/env python3
"""Runs the commands of docs/scene.md that draw pictures and compares each with the one in docs/scenes; and the picture of README.

scene_pictures.py TPS ROOT [--write]      exit code 1 if one differs, or if one is on the page and not drawn, or the reverse
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def main():
    tps, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    page = (root / "docs/scene.md").read_text(encoding="utf-8")
    section = page.split("\n## Scenes of the outlook\n")[1].split("\n## ")[0]
    commands = "\n".join(re.findall(r"^```sh\n(.*?)^```", section, re.M | re.S))
    front = f"tps run '{root.resolve()}/data/scenes/terminal.json' -q -o terminal.ndjson\ntps draw terminal.ndjson -o terminal.svg"
    shown = set(re.findall(r"\(scenes/([\w-]+\.svg)\)", section))
    folder, faults = root / "docs/scenes", []
    with tempfile.TemporaryDirectory() as work:
        environment = os.environ | {"PATH": f"{tps.parent}:{os.environ['PATH']}"}
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", f"{commands}\n{front}"], cwd=work, env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if done.returncode:
            sys.exit(f"scene_pictures.py: the commands of docs/scene.md end with {done.returncode}:\n{done.stdout}")
        drawn = {path.name: path.read_text(encoding="utf-8") for path in pathlib.Path(work).glob("*.svg")}
    front_drawn, front_kept = drawn.pop("terminal.svg"), root / "docs/terminal.svg"
    if "--write" in sys.argv[3:]:
        front_kept.write_text(front_drawn, encoding="utf-8")
        for name, picture in drawn.items():
            (folder / name).write_text(picture, encoding="utf-8")
    kept = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.svg")}
    for name in sorted(shown | set(drawn) | set(kept)):
        if name not in shown:
            faults.append(f"{name} is shown nowhere in docs/scene.md")
        elif drawn.get(name) != kept.get(name):
            faults.append(f"docs/scenes/{name} is not what the commands of docs/scene.md draw; "
                          "if that is meant: tests/docs/scene_pictures.py TPS ROOT --write")
    if front_drawn != front_kept.read_text(encoding="utf-8"):
        faults.append("docs/terminal.svg is not how data/scenes/terminal.json ends")
    print("\n".join(faults) or f"{len(shown)} pictures are what the page's commands draw")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
