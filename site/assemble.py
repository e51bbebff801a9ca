#!/usr/bin/env python3
"""Puts the sources of the site together: assemble.py TARGET WEBASSEMBLY_FOLDER TPS.

The pages of docs/ as they are, but for two things. Links to files of the repository lead to copies of them, as text, since the site
is read without the repository; links to folders become plain words. And a page of an equation gets its live figure below the
heading. Beside them: KaTeX, the scripts of site/live/, the reference as WebAssembly, and cases for "a hard case"."""
import base64
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KATEX = pathlib.Path("/usr/share/javascript/katex")
LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```$", re.M | re.S)
CASES_OF_A_STRATUM = 3
LIVE = {"eq1": "distance", "eq2": "block_time tether_time paper_time", "eq3": "apply_impulse", "eq4": "collision_impulse",
        "eq5": "tether_response revolution_impulse", "eq6": "load", "eq7": "restitution_impulse"}


def with_links(text, page, copied):
    """The text with its links made fit for the site; `copied` gets the files that they lead to."""
    def fit(match):
        words, link = match.groups()
        path, _, anchor = link.partition("#")
        if re.match(r"[a-z]+:", link) or not path:
            return match.group(0)
        target = (page.parent / path).resolve()
        pages = (ROOT / "docs", ROOT / "site" / "pages")  # in the site they lie side by side
        if page.parent in pages and "/" not in path and any((folder / path).suffix == ".md" and (folder / path).exists() for folder in pages):
            return match.group(0)
        if target == ROOT / "README.md":
            return f"[{words}](index.md)"
        if not target.is_relative_to(ROOT) or not target.is_file():
            return words
        name = target.relative_to(ROOT).as_posix()
        copied.add(name)
        kept = name if target.suffix in (".html", ".svg", ".png") else f"{name}.txt"
        return f"[{words}](files/{kept})"
    parts, end = [], 0
    for block in CODE.finditer(text):
        parts += [LINK.sub(fit, text[end:block.start()]), block.group(0)]
        end = block.end()
    return "".join(parts + [LINK.sub(fit, text[end:])])


def hard_cases():
    """A few planar cases of each stratum of known answers, by operation: {"op": [{"id", "why", "in"}, …]}."""
    cases = {}
    # Grazes and limits are where formulas differ; what is merely planar comes last.
    def order(file):
        return (not re.search(r"graze|touching|taut|tangent|limit", file.stem), "planar" in file.stem, file.stem)
    for file in sorted((ROOT / "data" / "vectors").glob("*.jsonl"), key=order):
        lines = [json.loads(line) for line in file.read_text().splitlines()]
        planar = [c for c in lines[1:] if "u_A" in c["in"] and len(c["in"]["u_A"]) == 2 or "v_A" in c["in"] and len(c["in"]["v_A"]) == 2]
        for case in planar[:CASES_OF_A_STRATUM]:
            cases.setdefault(lines[0]["op"], []).append({"id": case["id"], "why": lines[0]["why"], "in": case["in"]})
    return cases


def sections():
    """What the search looks through: [page, heading, anchor, text] of each section."""
    found = []
    for page in sorted((ROOT / "docs").glob("*.md")) + [ROOT / "site" / "pages" / "experiments.md"]:
        for part in re.split(r"^(?=#{1,4} )", CODE.sub("", page.read_text()), flags=re.M):
            heading, _, text = part.partition("\n")
            title = re.sub(r"[*`]|\[([^\]]*)\]\([^)]*\)", r"\1", heading.lstrip("# "))
            anchor = re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") if not heading.startswith("# ") else ""
            plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
            if heading.startswith("#"):
                found.append([f"{page.stem}.html", title, anchor, " ".join(re.sub(r"[|*`#]+|<[^>]*>|-{3,}", " ", plain).split())])
    return found


def reference_script(wasm):
    """Loader and module as texts, since a page that is opened as a file may not fetch any."""
    loader = (wasm / "tps_web.js").read_text()
    module = base64.b64encode((wasm / "tps_web.wasm").read_bytes()).decode()
    return f"window.tpsReferenceFiles = {json.dumps({'loader': loader, 'module': module})};\n".replace("</", "<\\/")


def headers():
    """The headers that compute each operation, in the order in which they do."""
    frame, time = "collision_frame", ["eq2_approach", "eq2_collision_time"]
    names = {"distance": ["eq1_distance"], "block_time": time, "tether_time": time, "paper_time": ["eq2_paper_time"], "apply_impulse": ["eq3_apply_impulse"],
             "collision_impulse": [frame, "eq4_collision_impulse"], "revolution_impulse": [frame, "eq5_revolution_impulse"],
             "tether_response": [frame, "tether_response", "eq4_collision_impulse", "eq5_revolution_impulse"], "load": ["eq6_load_velocity"],
             "restitution_impulse": ["eq7_restitution_impulse"]}
    folder = ROOT / "reference" / "equations"
    return {op: "\n".join(f"// reference/equations/{name}.hpp\n" + (folder / f"{name}.hpp").read_text() for name in list_) for op, list_ in names.items()}


def main():
    target, wasm, tps = map(pathlib.Path, sys.argv[1:4])
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    copied = set()
    for page in sorted((ROOT / "docs").glob("*.md")) + sorted((ROOT / "site" / "pages").glob("*.md")):
        text = with_links(page.read_text(), page, copied)
        if page.stem in LIVE:
            heading, _, rest = text.partition("\n")
            text = f'{heading}\n\n<div class="tps-equation" data-ops="{LIVE[page.stem]}"></div>\n{rest}'
        (target / page.name).write_text(text)
    shutil.copy(ROOT / "docs" / "terminal.svg", target)
    shutil.copytree(ROOT / "docs" / "scenes", target / "scenes")
    for name in sorted(copied):
        kept = name if name.endswith((".html", ".svg", ".png")) else f"{name}.txt"
        (target / "files" / kept).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, target / "files" / kept)
    (target / "katex" / "fonts").mkdir(parents=True)
    shutil.copy(KATEX / "katex.min.css", target / "katex")
    shutil.copy(KATEX / "katex.min.js", target / "katex")
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copy(font, target / "katex" / "fonts")
    shutil.copytree(ROOT / "site" / "live", target / "live")
    (target / "live" / "reference.js").write_text(reference_script(wasm))
    (target / "live" / "cases.js").write_text(f"window.tpsCases = {json.dumps(hard_cases())};\nwindow.tpsHeaders = {json.dumps(headers())};\n".replace("</", "<\\/"))
    (target / "live" / "sections.js").write_text(f"window.tpsSections = {json.dumps(sections())};\n".replace("</", "<\\/"))
    subprocess.run([tps, "view", ROOT / "data" / "scenes" / "terminal.json", "--quiet", "-o", target / "terminal.html"], check=True)


if __name__ == "__main__":
    main()
