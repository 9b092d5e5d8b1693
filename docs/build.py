"""The documentation site, from the pages of this folder: `python docs/build.py [FOLDER]`, by default into `build/site`.

Pages stay plain Markdown that GitHub shows. What only a site can have is added to a copy of them: the order of pages,
the reference of the code, the pictures of the gallery, and the notebooks, executed. A warning is an error.
"""

from __future__ import annotations

import argparse
import base64
import json
import re
import shutil
import sys
import tempfile
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from html import escape
from pathlib import Path
from typing import Any

from nbformat import NotebookNode
from sphinx.cmd.build import build_main

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path[:0] = [str(ROOT / "notebooks"), str(HERE)]
import build as notebooks  # noqa: E402
from sentences import parts_of  # noqa: E402

PARTS = {
    "Start": ("start", "first-robot", "lab"),
    "Course": ("notebooks/index", "lesson.en", "worksheet.en"),
    "En español": ("index.es", "start.es", "lab.es", "lesson.es", "worksheet.es", "notebooks/es/index"),
    "How to": ("how-to", "add-a-robot", "extend", "examples/index"),
    "Concepts": (
        "model", "logs", "calibrate", "identify", "excite", "certificate", "post-mortem", "fleet",
        "firmware",
    ),
    "Reference": ("api", "conventions", "glossary", "gallery", "figures", "benchmarks/index", "scale"),
    "The project": ("architecture", "contributing", "changes"),
}  # fmt: skip
"""The order of the site; a page that no part has comes last."""

OUTSIDE = {"contributing": "CONTRIBUTING.md", "changes": "CHANGELOG.md", "benchmarks/index": "benchmarks/README.md"}
"""Pages of the site that stand elsewhere in the checkout."""

REFERENCE = {
    "From a robot to a run": (
        "Robot", "Kit", "run", "Log", "Signal", "compare", "report", "example",
    ),
    "Bodies": ("NonlinearBody", "LinearBody", "Twin", "Electronics"),
    "Pushes and references": ("Hold", "Impulse", "Push", "Slope", "Drive", "Turn"),
    "Models": ("linearise", "LinearModel"),
    "Controllers": (
        "design", "lqr", "lqi", "lqg", "pid", "hinf", "mpc", "sliding", "robust", "kalman", "complementary",
        "StateFeedback", "Estimated", "tune",
    ),
    "From a log": ("doctor", "calibrate", "identify", "validate", "excite", "post_mortem"),
    "Before it drives": ("certify", "parity"),
    "Many robots": ("fleet", "push_map"),
    "For a notebook": ("lab_page", "language"),
    "The paper, and errors": ("reproduce", "UprightError"),
}  # fmt: skip
"""What `import upright` offers, by what it is for; the rest comes last."""


def build(site: Path, *, draft: bool = False) -> int:
    """Write the site into the folder `site`, and return Sphinx's exit status; a `draft` executes nothing."""
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch) / "source"
        source.mkdir()
        _pages(source)
        _examples(source)
        _reference(source)
        _glossary(source)
        _course(source, draft)
        _archive(source)
        gallery = source / "gallery.md"
        if draft:
            _write(gallery, gallery.read_text("utf-8").replace(".*\n", f".*\n\n{WITHOUT}\n", 1))
        else:
            _gallery(gallery)
            index = source / "index.md"
            _write(index, PICTURE.sub(TRY, index.read_text("utf-8")))
            for name, button in (("start", NOW), ("start.es", AHORA)):
                start = source / f"{name}.md"
                _write(start, re.sub(r"\A(# .+\n\n\*.+\*\n)", rf"\1\n{button}\n", start.read_text("utf-8"), count=1))
            for name, button in (("lab", NOW), ("lab.es", AHORA)):
                lab = source / f"{name}.md"
                _write(
                    lab, re.sub(r"(\]\(lab(?:\.es)?\.webp\)\n)", rf"\1\n{button}\n", lab.read_text("utf-8"), count=1)
                )
            for page in source.glob("*.e?.md"):
                language = page.stem.rpartition(".")[2]
                _write(page, HERE_TOO.sub(partial(_tried, language=language), page.read_text("utf-8")))
        _order(source)
        arguments = ["-b", "html", "-c", str(HERE), "-W", "--keep-going", "-q", "-d", str(Path(scratch) / "doctrees")]
        if site.is_dir() and any(site.iterdir()) and not (site / "objects.inv").exists():
            sys.exit(f"docs/build.py: {site} holds files that are no such site; try: another folder")
        shutil.rmtree(site, ignore_errors=True)
        status = build_main([*arguments, str(source), str(site)])
        if status == 0:
            _about(source, site)
        if not draft and status == 0:
            _lab(site)
            notebooks.labs_beside(site / "notebooks", Path(scratch) / LABS)
    return status


LABS = "executed"
"""Where notebooks are executed, and write labs."""


TRIED = ("nxtway-gs", "herrera2015", "twipr")


def _lab(site: Path) -> None:
    """The lab of some robots, as a page that runs by itself; the first page leads to it."""
    from upright.lab.export import export

    export(site / "try", TRIED, say=lambda _: None)


BLANK = re.compile("_{8,}")
"""Where a student writes on a worksheet."""


def _pages(source: Path) -> None:
    for page in HERE.glob("*.md"):
        text = _switched(page, page.read_text("utf-8").replace("](../", "]("))
        text = re.sub(r"\]\((notebooks|examples|benchmarks)/README\.md\)", r"](\1/index.md)", text)
        if page.stem.endswith(".es"):
            text = text.replace("](notebooks/index.md)", "](notebooks/es/index.md)")
        _write(source / page.name, BLANK.sub('<span class="blank"></span>', text))
    for picture in [*HERE.glob("*.gif"), *HERE.glob("*.webp")]:
        shutil.copy(picture, source)
    for name, path in OUTSIDE.items():
        text = (ROOT / path).read_text("utf-8").replace("](docs/", "](")
        _write(source / f"{name}.md", "---\nnosearch: true\n---\n" * (name == "changes") + text)
    for linked in re.findall(r"\]\(((?:src|benchmarks)/[^)#]+\.py)\)", "".join(_texts(source))):
        (source / linked).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / linked, source / linked)


SWITCH = {"es": "English", "en": "Español"}
"""What leads from a page in one language to the same page in the other."""


def _switched(page: Path, text: str) -> str:
    """A page NAME.LANGUAGE.md, or NAME.md in English, with the way to its other language below its first lines."""
    name, _, language = page.stem.partition(".")
    (other,) = SWITCH.keys() - {language or "en"}
    there = [page.with_name(file) for file in (f"{name}.{other}.md", f"{name}.md") if file != page.name]
    target = next((file.name for file in there if file.exists()), "")
    if not target or f"]({target})\n" in text.partition("\n## ")[0]:
        return text
    return re.sub(r"\A(# .+\n\n\*.+\*\n)", rf"\1\n[{SWITCH[language or 'en']}]({target})\n", text)


ARCHIVE = "upright.zip"
PACKED = ("pyproject.toml", "README.md", "LICENSE", "CITATION.cff", "CHANGELOG.md", "src", "examples", "notebooks")
GET = {
    "start.md": ("## 1. Install\n\n", f"Download [{ARCHIVE}]({ARCHIVE}) and unpack it. "),
    "start.es.md": ("## 1. Instalar\n\n", f"Descargue [{ARCHIVE}]({ARCHIVE}) y descomprímalo. "),
}
"""The pages that say how to install, each with its title and what stands below it on the site, where the archive is."""


def _archive(source: Path) -> None:
    """What `pip install .` needs, as a download of the site."""
    with zipfile.ZipFile(source / ARCHIVE, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(p for name in PACKED for p in [ROOT / name, *(ROOT / name).rglob("*")] if p.is_file()):
            inside = path.relative_to(ROOT)
            if not {"node_modules", "__pycache__"}.intersection(inside.parts):
                archive.write(path, Path("upright") / inside)
    for name, (title, words) in GET.items():
        page = source / name
        _write(page, page.read_text("utf-8").replace(title, title + words, 1))


WHOM = re.compile(r"\A(?:---\n.*?---\n)?# [^\n]+\n\n\*(.+?)\*\n", re.DOTALL)


def _about(source: Path, site: Path) -> None:
    """For whom each page is, and its sentences, which stand below it where it is found: `site.js` shows them."""
    pages = {
        page.relative_to(source).with_suffix("").as_posix(): page.read_text("utf-8") for page in source.rglob("*.md")
    }
    whom = {
        name: " ".join(found[1].replace("`", "").split()) for name, text in pages.items() if (found := WHOM.match(text))
    }
    texts = {name: text for name in pages if (text := parts_of((site / f"{name}.html").read_text("utf-8")))}
    about = json.dumps({"whom": whom, "texts": texts}, ensure_ascii=False, separators=(",", ":"))
    _write(site / "_static" / "about.js", f"window.aboutPages = {about};\n")


def _texts(source: Path) -> list[str]:
    return [page.read_text("utf-8") for page in sorted(source.glob("*.md"))]


def _examples(source: Path) -> None:
    """The scripts of `examples/` below their table, each as its text."""
    page = (ROOT / "examples" / "README.md").read_text("utf-8")
    scripts = [ROOT / "examples" / name for name in re.findall(r"\]\((\w+\.py)\)", page)]
    page = re.sub(r"\]\((\w+)\.py\)", r"](#example-\1)", page)
    parts = [f"(example-{s.stem})=\n## {s.name}\n\n```python\n{s.read_text('utf-8')}```\n" for s in scripts]
    _write(source / "examples" / "index.md", "\n".join([page, *parts]))


def _with_the_rest(parts: Mapping[str, Sequence[str]], names: Iterable[str]) -> dict[str, Sequence[str]]:
    """The parts, and what none of them has as the last one."""
    rest = sorted(set(names) - {name for part in parts.values() for name in part})
    return dict(parts) | ({"More": rest} if rest else {})


def _reference(source: Path) -> None:
    import upright

    whom = "*For everybody who writes Python; `import upright as up` offers everything on this page.*"
    groups = _with_the_rest(REFERENCE, upright.__all__)
    parts = [f"# Python reference\n\n{whom}\n"]
    for title, names in groups.items():
        parts += [f"**{title}**\n", "| name | what it is |\n|---|---|", *(_row(name) for name in names), ""]
    for title, names in groups.items():
        parts += [f"## {title}\n", *(_entry(name) for name in names)]
    _write(source / "api.md", "\n".join(parts))


def _row(name: str) -> str:
    """A name with the first sentence of its docstring."""
    import upright

    text = " ".join((getattr(upright, name).__doc__ or "").partition("\n\n")[0].split())
    first = re.split(r"(?<=[.;]) ", text)[0].rstrip(";").replace("|", "\\|")
    return f"| {{py:obj}}`~upright.{name}` | {first} |"


def _entry(name: str) -> str:
    import upright

    kind = "autoclass" if isinstance(getattr(upright, name), type) else "autofunction"
    members = "   :members:\n" if kind == "autoclass" else ""
    return f"```{{eval-rst}}\n.. {kind}:: upright.{name}\n{members}```\n"


def _glossary(source: Path) -> None:
    """The table of conventions.md as a page of its own."""
    table = (HERE / "conventions.md").read_text("utf-8").partition("## Glossary\n")[2]
    _write(source / "glossary.md", f"# Glossary\n\n*For everybody; English and Spanish.*\n{table}")


NOW = '<p><a class="now" href="try/index.html">Push it yourself, now, in this browser</a></p>'
AHORA = '<p><a class="now" href="try/index.html#lang=es">Empújelo, aquí mismo</a></p>'
PICTURE = re.compile(r"\[!\[[^]]*\]\(lab\.webp\)\]\(lab\.md#[\w-]+\)\n\n\[.*\n")
SHOWN = '<img src="_images/lab.webp" alt="The lab: a robot is knocked and stays up">'
TRY = f'{NOW}<p><a href="try/index.html">{SHOWN}</a></p>\n'
"""The first picture of the site leads to the lab itself, in the place of the page about it."""

HERE_TOO = re.compile(r"\[([^]]+)\]\(http://127\.0\.0\.1:8765/#([^)]+)\)|`#(controller=[^`]+)`")
"""In lessons and worksheets: a link to the lab of this computer, or what is added to the lab's address."""


def _tried(link: re.Match[str], language: str) -> str:
    """The same as a link to the lab that is a page of the site, in the page's language."""
    words, what = (link[1], link[2]) if link[1] else (f"<code>#{link[3]}</code>".replace("&", "&amp;"), link[3])
    if what == f"lang={language}" and link.string[: link.start()].endswith("\n"):  # a paragraph of its own
        return f'<a class="now" href="try/index.html#{what}">{words}</a>'
    return f'<a href="try/index.html#{what.replace("&", "&amp;")}&amp;lang={language}">{words}</a>'


FENCE = re.compile(r"^```python\n(.*?)^```\n", re.MULTILINE | re.DOTALL)


WITHOUT = "```{note}\nThis is a draft. `python docs/build.py` draws the picture below each example.\n```"


NARROW = 0.5
"""Of a figure's width that is enough for its letters to be read on a phone."""


def _gallery(page: Path) -> None:
    """Each example of the gallery is executed, and the `figure` that it makes stands below it."""
    names: dict[str, object] = {"__name__": "gallery"}
    count = iter(range(1000))

    def drawn(fence: re.Match[str]) -> str:
        names.pop("figure", None)
        exec(compile(fence[1], "gallery.md", "exec"), names)
        figure: Any = names["figure"]
        keys = [(key, ax) for ax in figure.axes if (key := ax.get_legend())]
        for key, ax in keys:
            key.set_loc("upper left")  # beside the panel, over no line
            key.set_bbox_to_anchor((1.0, 1.0), ax.transAxes)
        number, (width, height) = next(count), figure.get_size_inches()
        shown, round_ones = "", any(ax.get_aspect() != "auto" for ax in figure.axes)
        for name, scale in (("wide", 1.0), ("narrow", NARROW)):
            path = f"gallery-{number}-{name}.svg"
            tall = scale if round_ones else max(scale, 0.8)
            figure.set_size_inches(scale * width, tall * height)
            if name == "narrow":
                _key_below(figure, keys)
            figure.savefig(page.with_name(path), bbox_inches="tight")
            shown += f"![What the example below draws]({path}){{.{name}}}\n"
        return f"{shown}\n{fence[0]}"

    _write(page, FENCE.sub(drawn, page.read_text("utf-8")))


def _key_below(figure: Any, keys: Sequence[tuple[Any, Any]]) -> None:
    """One key for all panels, below them, where a phone has no room beside them."""
    named: dict[str, Any] = {}
    for key, ax in keys:
        key.set_visible(False)
        named |= dict(zip(*reversed(ax.get_legend_handles_labels()), strict=True))
    if named:
        figure.legend([*named.values()], [*named], loc="upper left", bbox_to_anchor=(0.0, 0.0), frameon=False)


def _course(source: Path, draft: bool) -> None:
    """The page of the course, and each notebook as a page in both languages, with the student's to take away."""
    page = (ROOT / "notebooks" / "README.md").read_text("utf-8").replace("](../docs/", "](../")
    folder = source / "notebooks"
    names: list[str] = []
    files = source.parent / LABS
    files.mkdir()
    for text in notebooks.texts():
        names.append(text.stem)
        plain = [(cell, notebooks.node_of(cell)) for cell in notebooks.cells_of(text)]
        ran = dict.fromkeys(notebooks.LANGUAGES, plain) if draft else notebooks.executed(text, files)
        for lang in notebooks.LANGUAGES:
            student = notebooks.notebook_of(ran[lang], lang, teacher=False)
            path = folder / lang / f"{text.stem}.md"
            take = path.with_suffix(".ipynb")
            _write(take, notebooks.nbformat.writes(student))
            _write(path, _notebook_page(student, path, take.name, TAKE[lang]))
    for lang, (title, whom) in LANGUAGE.items():
        rows = "".join(f"- [{_title(folder / lang / f'{name}.md')}]({name}.md)\n" for name in names)
        _write(folder / lang / "index.md", f"# {title}\n\n*{whom}*\n\n{rows}{_tree('', names)}")
    _write(folder / "build.py", (ROOT / "notebooks" / "build.py").read_text("utf-8"))
    _write(folder / "index.md", re.sub(r"\]\((\d_\w+)\.py\)", r"](en/\1.md)", page) + _tree("", ["en/index"]))


def _title(page: Path) -> str:
    return page.read_text("utf-8").partition("\n")[0].lstrip("# ")


LANGUAGE = {
    "en": ("In English", "For students; take a notebook with you, or read it here."),
    "es": ("El curso: seis cuadernos", "Para estudiantes; lleve consigo un cuaderno, o léalo aquí."),
}
TAKE = {"en": "Take this notebook with you", "es": "Lleve consigo este cuaderno"}


def _notebook_page(notebook: NotebookNode, page: Path, take: str, words: str) -> str:
    """A notebook as Markdown: its title, the link to the notebook itself, and the other cells with their outputs."""
    parts: list[str] = []
    for number, cell in enumerate(notebook.cells):
        if cell.cell_type == "markdown":
            parts.append(re.sub(r"\]\((\d_\w+)\.ipynb\)", r"](\1.md)", cell.source) + "\n")
        else:
            parts.append(f"```python\n{cell.source}\n```\n")
            parts += [_output(out, page, f"{page.stem}-{number}-{k}") for k, out in enumerate(cell.outputs)]
    lang = page.parent.name
    (other,) = SWITCH.keys() - {lang}
    links = f"[{words}]({take}) · [{SWITCH[lang]}](../{other}/{page.name})\n"
    return "\n".join([parts[0], links, *parts[1:]])


def _output(output: NotebookNode, page: Path, name: str) -> str:
    if output.output_type == "stream":
        return _block(_printed(output.text)) if output.name == "stdout" else ""
    data = output.data
    if "image/png" in data:
        path = page.parent / f"{name}.png"
        path.write_bytes(base64.b64decode(data["image/png"]))
        width = output.metadata.get("image/png", {}).get("width")
        return f"![{DRAWN[page.parent.name]}]({path.name})" + (f"{{width={width}px}}\n" if width else "\n")
    if "<iframe" in (framed := data.get("text/html", "")):
        own = re.sub(r'(src|href)="(lab-[^"]+)', rf'\1="../\2&amp;lang={page.parent.name}', framed)
        return _block(own)  # both languages show the same page
    return _block(framed or _printed(data.get("text/plain", "")))


CELL = 20
"""Letters: what begins further in goes on with the last cell of a row."""
DRAWN = {"en": "A figure that this cell draws", "es": "La figura que dibuja esta celda"}


def _printed(text: str) -> str:
    """What a cell prints: a sentence breaks below its indent, a row below its last cell (not on a phone)."""
    lines: list[str] = []
    for line in text.rstrip("\n").split("\n"):
        cells = [gap.end() for gap in re.finditer(r"(?<=\S) {2,}(?=\S)", line)]
        hang = cells[-1] if cells else len(line) - len(line.lstrip()) + 2
        row = " cells" * (bool(cells) or hang > CELL)
        lines.append(f'<span class="printed{row}" style="--in: {hang}ch">{escape(line)}\n</span>')
    return f"<pre>{''.join(lines)}</pre>"


def _block(html: str) -> str:
    fence = ":::::"
    return f'{fence}{{raw}} html\n<div class="output" tabindex="0">{html}</div>\n{fence}\n'


def _order(source: Path) -> None:
    pages = {page.relative_to(source).with_suffix("").as_posix() for page in source.rglob("*.md")}
    own = {page for page in pages - {"index"} if not page.startswith("notebooks/")}
    with (source / "index.md").open("a", encoding="utf-8") as index:
        index.write("".join(_tree(title, names) for title, names in _with_the_rest(PARTS, own).items()))


def _tree(title: str, names: Sequence[str]) -> str:
    rows = "\n".join(names)
    caption = f":caption: {title}\n" if title else ""
    return f"\n```{{toctree}}\n{caption}:hidden:\n\n{rows}\n```\n"


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("site", nargs="?", type=Path, default=ROOT / "build" / "site")
    parser.add_argument("--draft", action="store_true", help="execute no notebook and draw no gallery")
    given = parser.parse_args()
    status = build(given.site.resolve(), draft=given.draft)
    print(f"{given.site / 'index.html'}" if status == 0 else "the site was not built without warnings")
    return status


if __name__ == "__main__":
    sys.exit(main())
