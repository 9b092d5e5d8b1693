"""The documentation site, from the pages of this folder: `python docs/build.py [FOLDER]`, by default into `build/site`.

Pages stay plain Markdown that GitHub shows. What only a site can have is added to a copy of them: the order of pages,
the reference of the code, the pictures of the gallery, the notebooks, executed, and the lab. NAME.es.md is NAME in
Spanish, for a site of its own in the folder `es`, with its own search. A warning is an error.
"""

from __future__ import annotations

import argparse
import base64
import re
import shutil
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import Any

from nbformat import NotebookNode
from sphinx.cmd.build import build_main

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.insert(0, str(ROOT / "notebooks"))
import build as notebooks  # noqa: E402

PARTS = {
    "en": {
        "Start": "first-robot lab",
        "Course": "notebooks/index lesson",
        "How to": "how-to arduino add-a-robot steppers extend examples/index",
        "Concepts": "model logs calibrate identify excite certificate post-mortem fleet firmware",
        "Studies": "studies/coarse-counts studies/dead-zone studies/resonance studies/gain studies/optima studies/mass "
        "studies/outside studies/falls studies/likelihood studies/hypotheses",
        "Reference": "api schemas conventions benchmarks/index",
        "The project": "architecture contributing changes",
    },
    "es": {"En español": "lab lesson notebooks/index"},
}
"""The order of the pages; Sphinx names a page that no part has."""

OUTSIDE = {
    "contributing": "CONTRIBUTING.md", "changes": "CHANGELOG.md", "benchmarks/index": "benchmarks/README.md",
    "examples/index": "examples/README.md",
}  # fmt: skip
"""Pages of the site that stand elsewhere in the checkout."""

REFERENCE = {
    "From a robot to a run": "Robot Kit simulate run Log Signal compare report example",
    "Bodies": "Body BodySpec Sample NonlinearBody LinearBody Twin Electronics",
    "Pushes and references": "Hold Impulse Push Slope Drive Turn",
    "Models": "linearise LinearModel",
    "Controllers": "design lqr lqi lqg pid pid_angle hinf mpc sliding robust kalman complementary tune",
    "What controllers are": "Controller ControllerSpec StateFeedback lqr_state Lqr LinearController Estimated",
    "Estimators and laws": "Kalman Complementary AnglePid PredictiveController SlidingMode",
    "From a log": "doctor calibrate identify validate excite post_mortem",
    "Before it drives": "certify parity",
    "Many robots": "fleet push_map",
    "Results": "Simulation Comparison Designed Analysis Margins Tuned Diagnosis Calibration Validation Identified "
    "MethodComparison ExcitationPlan PostMortem Certificate Parity Fleet PushMap Basin Reproduction",
    "For a notebook": "lab_page LabPage language",
    "The paper, and errors": "reproduce UprightError",
}
"""What `import upright` offers, by what it is for."""

COURSE = {
    "en": ("The course", "For students; take a notebook with you, or read it here.", "Take this notebook with you"),
    "es": ("El curso", "Para estudiantes; lleve consigo un cuaderno, o léalo aquí.", "Lleve consigo este cuaderno"),
}
INSTALL = {
    "en": ("## Install\n\n", 'Download <a href="upright.zip">upright.zip</a> and unpack it. '),
    "es": ("## Instalar\n\n", 'Descargue <a href="../upright.zip">upright.zip</a> y descomprímalo. '),
}
"""The title above which says how to install, and what stands below it where the archive can be had."""
PACKED = ("pyproject.toml", "README.md", "LICENSE", "CITATION.cff", "CHANGELOG.md", "src", "examples", "notebooks")
"""What `pip install .` needs, and what is read beside it."""
MADE = {"__pycache__", "node_modules"}  # folders of these, which are made again


def build(site: Path, *, draft: bool = False) -> int:
    """Write the site into the folder `site`, and return Sphinx's exit status; a `draft` executes nothing."""
    if site.is_dir() and any(site.iterdir()) and not (site / "objects.inv").exists():
        sys.exit(f"docs/build.py: {site} holds files that are no such site; try: another folder")
    shutil.rmtree(site, ignore_errors=True)
    status = 0
    with tempfile.TemporaryDirectory() as scratch:
        labs = Path(scratch) / "labs"
        labs.mkdir()
        course = {text: notebooks.executed(text, labs) if not draft else {} for text in notebooks.texts()}
        for language, folder in (("en", site), ("es", site / "es")):
            source = Path(scratch) / language
            _pages(source, language)
            _course(source / "notebooks", language, course)
            if language == "en":
                _reference(source / "api.md")
                _gallery(source / "how-to.md", draft)
            options = ["-Wq", "-c", str(HERE), "-D", f"language={language}", "-d", f"{source}.trees"]
            status = status or build_main([*options, str(source), str(folder)])
        shutil.copytree(ROOT / "src" / "upright" / "pages" / "schemas", site / "schemas")
        _archive(site / "upright.zip")
        if status == 0 and not draft:
            from upright.lab.export import export

            export(site / "try", ("nxtway-gs", "herrera2015", "twipr"), say=lambda _: None)
            notebooks.labs_beside(site / "notebooks", labs)
    return status


def _archive(target: Path) -> None:
    """What `pip install .` needs, as one file: also from a copy of the project that is no git checkout."""
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in PACKED:
            for path in (ROOT / name, *sorted((ROOT / name).rglob("*"))):
                if path.is_file() and MADE.isdisjoint(path.parts):
                    archive.write(path, Path("upright", path.relative_to(ROOT)))


LINK = re.compile(r"\[([^]]+)\]\(([\w-]+)(?:\.(en|es))?\.md(#[^)\s]*)?\)")
"""A link to a page: its words, the page's name, its language, and a place in it."""


def _pages(source: Path, language: str) -> None:
    def linked(link: re.Match[str]) -> str:
        words, name, there, place = link[1], link[2], link[3] or "en", link[4] or ""
        if there == language:
            return f"[{words}]({name}.md{place})"
        return f'<a href="{"es" if there == "es" else ".."}/{name}.html{place}">{words}</a>'

    shutil.copytree(HERE, source, ignore=shutil.ignore_patterns("*.md", "*.py", "__pycache__", "_static"))
    pages = {page.name.split(".")[0]: page for page in HERE.glob("*.md") if (".es." in page.name) == (language == "es")}
    if language == "en":
        pages |= {n: ROOT / path for n, path in OUTSIDE.items()}
        pages |= {f"studies/{page.stem}": page for page in HERE.glob("studies/*.md")}
    for name, page in pages.items():
        text = page.read_text("utf-8").replace("](../docs/", "](../").replace("](docs/", "](")
        text = text.replace("](../", "](") if page.parent == HERE else text
        text = re.sub(r"\]\((notebooks|examples|benchmarks)/README\.md", r"](\1/index.md", text)
        _write(source / f"{name}.md", LINK.sub(linked, text).replace(f".{language}.md", ".md"))
        for file in re.findall(r"\]\(([\w/-]+\.(?:py|json))\)", text):  # to be taken away
            taken = (source / f"{name}.md").parent / file
            taken.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy((ROOT if page.parent == HERE else page.parent) / file, taken)
    index = source / "index.md"
    title, words = INSTALL[language]
    trees = "".join(_tree(part, names) for part, names in PARTS[language].items())
    _write(index, index.read_text("utf-8").replace(title, title + words, 1) + trees)


def _tree(title: str, names: str) -> str:
    caption = f":caption: {title}\n" if title else ""
    return f"\n```{{toctree}}\n{caption}:hidden:\n\n" + "\n".join(names.split()) + "\n```\n"


def _reference(page: Path) -> None:
    import upright

    parts = ["# Python reference\n\n*For everybody who writes Python: what `import upright as up` offers.*\n"]
    for title, names in REFERENCE.items():
        rows = [f"   upright.{name}" for name in names.split()]
        parts.append(f"## {title}\n\n```{{eval-rst}}\n.. autosummary::\n   :nosignatures:\n\n" + "\n".join(rows) + "\n")
        for name in names.split():
            what = "autoclass" if isinstance(getattr(upright, name), type) else "autofunction"
            parts.append(f".. {what}:: upright.{name}\n" + "   :members:\n" * (what == "autoclass"))
        parts.append("```\n")
    _write(page, "\n".join(parts))


def _gallery(page: Path, draft: bool) -> None:
    """Each example that makes a `figure` is executed, and what it draws stands above it."""
    names: dict[str, Any] = {"__name__": "gallery"}
    drawn: list[str] = []

    def shown(fence: re.Match[str]) -> str:
        exec(compile(fence[1], page.name, "exec"), names)
        drawn.append(f"gallery-{len(drawn)}.svg")
        names["figure"].savefig(page.with_name(drawn[-1]), bbox_inches="tight")
        return f"![What the example below draws]({drawn[-1]})\n\n{fence[0]}"

    fences = re.compile(r"^```python\n((?:(?!```).*\n)*?figure = (?:.*\n)*?)```\n", re.MULTILINE)
    if not draft:
        _write(page, fences.sub(shown, page.read_text("utf-8")))


def _course(folder: Path, language: str, course: dict[Path, dict[str, list[NotebookNode]]]) -> None:
    """Each notebook as a page in this language, with the student's to take away."""
    title, whom, take = COURSE[language]
    other = {
        "en": '<a href="../es/notebooks/{}.html">Español</a>',
        "es": '<a href="../../notebooks/{}.html">English</a>',
    }
    rows = ""
    for text, ran in course.items():
        name = text.stem
        student = notebooks.notebook_of(ran.get(language) or notebooks.cells_of(text), language, teacher=False)
        _write(folder / f"{name}.ipynb", notebooks.nbformat.writes(student))
        first, *cells = student.cells
        links = f"[{take}]({name}.ipynb) · {other[language].format(name)}"
        parts = [_cell(cell, folder / f"{name}-{number}", language) for number, cell in enumerate(cells)]
        _write(folder / f"{name}.md", "\n\n".join([first.source, links, *parts]))
        rows += f"- [{first.source.splitlines()[0].lstrip('# ')}]({name}.md)\n"
    page = f"# {title}\n\n*{whom}*\n\n{other[language].format('index')}\n\n{rows}"
    _write(folder / "index.md", page + _tree("", " ".join(text.stem for text in course)))


def _cell(cell: NotebookNode, path: Path, language: str) -> str:
    """A cell of a notebook as Markdown, with its outputs; pictures are written beside it, as `path` and a number."""
    if cell.cell_type == "markdown":
        return re.sub(r"\]\((\d_\w+)\.ipynb\)", r"](\1.md)", cell.source)
    parts = [f"```python\n{cell.source}\n```"]
    for number, out in enumerate(cell.outputs):
        data = out.get("data", {})
        if png := data.get("image/png"):
            picture = path.with_name(f"{path.name}-{number}.png")
            picture.write_bytes(base64.b64decode(png))
            width = out.metadata.get("image/png", {}).get("width", "")
            alt = {"en": "A figure that this cell draws", "es": "La figura que dibuja esta celda"}[language]
            parts.append(f"![{alt}]({picture.name})" + (f"{{width={width}px}}" if width else ""))
        elif html := data.get("text/html"):
            if language == "es":  # both languages show the same lab
                html = re.sub(r'(src|href)="(lab-[^"]+)', r'\1="../../notebooks/\2&amp;lang=es', html)
            parts.append(f'````{{raw}} html\n<div class="output" tabindex="0">{html}</div>\n````')
        elif out.get("name") != "stderr" and (said := out.get("text") or data.get("text/plain")):
            parts.append(f"````text\n{said.rstrip()}\n````")
    return "\n\n".join(parts)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("site", nargs="?", type=Path, default=ROOT / "build" / "site")
    parser.add_argument("--draft", action="store_true", help="execute no notebook and draw no gallery")
    given = parser.parse_args()
    if status := build(given.site.resolve(), draft=given.draft):
        sys.exit(status)
    print(given.site / "index.html")
