"""What the package says in one line, found in its source: `python tests/messages.py` prints what has no Spanish
yet, and Spanish that nothing says.

A message is an f-string of an error, of the command line or of its help. Here it becomes a template: what is literal,
and `{}` for each fact. Names are followed through assignments, constants, parameters (to all calls) and returned
values; what cannot be followed is a fact.
"""

from __future__ import annotations

import ast
import itertools
import re
import string
from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import budget
from upright.languages import ENGLISH, LANGUAGES, speaking
from upright.messages import HOLE, PART, in_language, sections

PARTS = ("expected", "likely", "hint")
SAID = {
    "Message": 0, "tell": 0, "complain": 0, "in_language": 0, "progress": 0, "Question": 1, "OwnerQuestion": 0,
    "GuidedStep": 0,
}  # fmt: skip
"""What shows one of its arguments: its place."""
LISTED = ("Firmware", "FlightPlan", "Flight")
"""Classes whose text the command line shows."""
TABLES = ("STOPPED", "TWINS", "INTERRUPTED")
"""Constants that it shows."""
MOST = 64  # templates of one expression
FEW = 6  # cases of one place in a sentence that make a template each
PACKAGE = budget.PACKAGE
Texts = frozenset[str]
FACT: Texts = frozenset({HOLE})


ENGLISH_WORD = re.compile(
    r"\b(the|of|is|are|was|with|for|and|from|at|row|has|have|its|it|this|that|which|but|not|than)\b", re.I
)
"""Words of which every English sentence has one, and no Spanish one."""

NO_WORDS = re.compile(
    r"upright:? \{\}|\{\}|(?:pip|apt) install [\w ]+(?:-\w+)*|(?:upright|mkdir) [\w-]+"  # commands
    r"|`[^`]*`|--?[\w-]+|\[[\w\[\].]+\]"  # code, options, tables
    r"|[\w./:<-]*[\d_./:=<][\w./:<>-]*[\w/>]|\b[A-Z]\w*[A-Z]\w*\b"  # files, names, units, abbreviations
)


def still_english(text: str) -> bool:
    """Whether English stands in a text beside what stays as it is typed or quoted."""
    typed = r"`[^`]*`|'[^']*'|\"[^\"]*\"|--?[\w-]+(?: [A-Z]+)?|upright [\w-]+"
    return bool(ENGLISH_WORD.search(re.sub(typed, "", text)))


def worded(template: str) -> bool:
    """Whether anything in a template is a word: what is typed has no translation."""
    return bool(re.search(r"[a-z]{2}", NO_WORDS.sub("", template)))


def pattern(template: str) -> re.Pattern[str]:
    """What a template fits."""
    return re.compile(re.escape(template).replace(re.escape(HOLE), ".*"))


def holes(translation: str) -> list[str]:
    """The places of facts in a translation."""
    return [name for _, name, _, _ in string.Formatter().parse(translation) if name is not None]


class Package:
    """The syntax trees of the package, and where each name is defined and called."""

    def __init__(self) -> None:
        self.trees = {path: nodes[0] for path, nodes in budget.nodes().items()}
        self.function_of: dict[int, ast.AST] = {}
        self.path_of: dict[int, Path] = {}
        self.calls: dict[str, list[ast.Call]] = defaultdict(list)
        self.functions: dict[str, list[ast.FunctionDef]] = defaultdict(list)
        self.classes: dict[str, ast.ClassDef] = {}
        self.constants: dict[str, list[ast.expr]] = defaultdict(list)
        self.raised: set[int] = set()
        for path, tree in self.trees.items():
            self._enter(tree, tree, path)
        self.errors = {"UprightError"}
        for _ in range(4):  # errors inherit from errors
            for name, node in self.classes.items():
                if any(isinstance(base, ast.Name) and base.id in self.errors for base in node.bases):
                    self.errors.add(name)

    def _enter(self, node: ast.AST, function: ast.AST, path: Path) -> None:
        for child in ast.iter_child_nodes(node):
            self.function_of[id(child)] = function
            self.path_of[id(child)] = path
            inside = function
            match child:
                case ast.FunctionDef() | ast.AsyncFunctionDef():
                    self.functions[child.name].append(child)
                    inside = child
                case ast.ClassDef():
                    self.classes[child.name] = child
                case ast.Call():
                    self.calls[_called(child)].append(child)
                case ast.Raise(exc=ast.Call() as call):
                    self.raised.add(id(call))
                case ast.Assign(targets=[ast.Name(id=name)], value=value) if isinstance(node, ast.Module):
                    self.constants[name].append(value)
                case ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value) if isinstance(
                    node, ast.Module | ast.ClassDef
                ):
                    self.constants[name].append(value)
            self._enter(child, inside, path)


def _called(call: ast.Call) -> str:
    match call.func:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


class Reader:
    """Reads expressions as templates; `nested` are the texts that stand in holes of others."""

    def __init__(self, package: Package) -> None:
        self.package = package
        self.nested: dict[str, str] = {}
        self.words: dict[str, str] = {}
        self._open: set[int] = set()
        self._known: dict[int, Texts] = {}

    def read(self, node: ast.AST | None) -> Texts:
        """The templates that an expression may be."""
        if node is None or id(node) in self._open:
            return FACT
        if id(node) in self._known:
            return self._known[id(node)]
        self._open.add(id(node))
        try:
            texts = self._read(node)
        finally:
            self._open.discard(id(node))
        self._known[id(node)] = texts if len(texts) <= MOST else FACT
        return self._known[id(node)]

    def _read(self, node: ast.AST) -> Texts:
        texts = FACT
        match node:
            case ast.Constant(value=str(text)):
                texts = frozenset({text})
            case ast.JoinedStr(values=values):
                texts = self._product([self._piece(value) for value in values])
            case ast.IfExp(body=one, orelse=other):
                texts = self.read(one) | self.read(other)
            case ast.BoolOp(values=values):
                texts = frozenset().union(*map(self.read, values))
            case ast.BinOp(left=left, op=ast.Add(), right=right):
                texts = self._product([self.read(left), self.read(right)])
            case ast.BinOp(left=left, op=ast.Mult()):
                texts = self.read(left) | {""}
            case ast.NamedExpr(value=value) | ast.Starred(value=value):
                texts = self.read(value)
            case ast.Subscript(value=held):
                texts = self._elements(held)
            case ast.Name(id=name):
                texts = self._named(name, node)
            case ast.Call():
                texts = self._returned(node)
        return texts

    def _piece(self, value: ast.AST) -> Texts:
        """Of an f-string. Words that are whole stay facts, which are translated by themselves; parts of a sentence
        make a template each."""
        if isinstance(value, ast.Constant):
            return frozenset({str(value.value)})
        assert isinstance(value, ast.FormattedValue)
        texts = self.read(value.value) if value.conversion == -1 and value.format_spec is None else FACT
        fragments = [text for text in texts if not re.match(r"[\w'`{-]", text) or text.endswith(" ")]
        if len(texts) <= FEW and HOLE not in texts and (fragments or not isinstance(value.value, ast.Name)):
            return texts
        place = f"{self.package.path_of[id(value)].relative_to(PACKAGE)}:{value.lineno}"
        for text in texts - {HOLE}:
            (self.nested if " " in text else self.words)[text] = place
        return FACT

    def _product(self, pieces: list[Texts]) -> Texts:
        size = 1
        for piece in pieces:
            size *= len(piece)
        if size > MOST:
            return FACT
        return frozenset(map("".join, itertools.product(*pieces)))

    def _elements(self, node: ast.AST) -> Texts:
        """The texts in a literal table, or under the name of one."""
        match node:
            case ast.Dict(values=values):
                return frozenset().union(*map(self._elements, values))
            case ast.Tuple(elts=values) | ast.List(elts=values) | ast.Set(elts=values):
                return frozenset().union(*map(self._elements, values))
            case ast.Name(id=name) if name in self.package.constants:
                own = [one for one in self.package.constants[name] if self._near(one, node)]
                return frozenset().union(*map(self._elements, own)) if own else FACT
            case ast.Constant(value=str(text)):
                return frozenset({text})
            case ast.JoinedStr():
                return self.read(node)
        return FACT

    def _near(self, one: ast.AST, other: ast.AST) -> bool:
        path, used = self.package.path_of[id(one)], self.package.path_of[id(other)]
        if path == used:
            return True
        module = path.relative_to(PACKAGE).with_suffix("").as_posix().replace("/", ".")
        module = module.removesuffix(".__init__")
        return bool(re.search(rf"from upright(\.{module} import|\b.* import .*\b{module}\b)", used.read_text("utf-8")))

    def _named(self, name: str, node: ast.AST) -> Texts:
        function = self.package.function_of[id(node)]
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            local = list(self._assigned(name, function))
            if local:
                return frozenset().union(*local)
            given = self._given(name, function)
            if given is not None:
                return given
            outer = self.package.function_of.get(id(function))
            if isinstance(outer, ast.FunctionDef) and (local := list(self._assigned(name, outer))):
                return frozenset().union(*local)
            if isinstance(outer, ast.FunctionDef) and (given := self._given(name, outer)) is not None:
                return given
        own = [one for one in self.package.constants.get(name, ()) if self._near(one, node)]
        return frozenset().union(*map(self.read, own)) if own else FACT

    def _assigned(self, name: str, function: ast.AST) -> Iterator[Texts]:
        """What is assigned to a name; also with what is added to it later."""
        first = list(self._set(name, function))
        yield from first
        for node in ast.walk(function):
            match node:
                case ast.AugAssign(target=ast.Name(id=found), value=value) if found == name and first:
                    yield self._product([frozenset().union(*first), self.read(value)])

    def _set(self, name: str, function: ast.AST) -> Iterator[Texts]:
        for node in ast.walk(function):
            match node:
                case ast.Assign(targets=targets, value=value):
                    for target in targets:
                        yield from self._unpacked(target, value, name)
                case ast.AnnAssign(target=ast.Name(id=found), value=ast.expr() as value) if found == name:
                    yield self.read(value)
                case ast.NamedExpr(target=ast.Name(id=found), value=value) if found == name:
                    yield self.read(value)
                case ast.For(target=target, iter=held) | ast.comprehension(target=target, iter=held):
                    yield from self._iterated(target, held, name)
                case ast.ExceptHandler(name=found) if found == name:
                    yield FACT
                case ast.withitem(optional_vars=ast.Name(id=found)) if found == name:
                    yield FACT

    def _unpacked(self, target: ast.AST, value: ast.AST, name: str) -> Iterator[Texts]:
        match target, value:
            case ast.Name(id=found), _ if found == name:
                yield self.read(value)
            case ast.Tuple(elts=targets), ast.Tuple(elts=values) if len(targets) == len(values):
                for one, other in zip(targets, values, strict=True):
                    yield from self._unpacked(one, other, name)
            case ast.Tuple(elts=targets), ast.IfExp(body=one, orelse=other):
                yield from self._unpacked(target, one, name)
                yield from self._unpacked(target, other, name)
            case ast.Tuple(elts=targets), _:
                for index, one in enumerate(targets):
                    if isinstance(one, ast.Name) and one.id == name:
                        yield self._tuple_returned(value, index)

    def _tuple_returned(self, value: ast.AST, index: int) -> Texts:
        """The text at a place of the tuple that a function returns or a table holds."""
        if isinstance(value, ast.Call):
            texts = [
                self.read(node.value.elts[index])
                for function in self.package.functions.get(_called(value), ())
                for node in ast.walk(function)
                if isinstance(node, ast.Return) and isinstance(node.value, ast.Tuple) and index < len(node.value.elts)
            ]
            return frozenset().union(*texts) if texts else FACT
        if isinstance(value, ast.Subscript):
            return self._column(value.value, index)
        return FACT

    def _column(self, held: ast.AST, index: int) -> Texts:
        match held:
            case ast.Name(id=name) if name in self.package.constants:
                own = [one for one in self.package.constants[name] if self._near(one, held)]
                return frozenset().union(*(self._column(one, index) for one in own)) if own else FACT
            case ast.Dict(values=rows) | ast.Tuple(elts=rows) | ast.List(elts=rows):
                found = [
                    self.read(row.elts[index]) for row in rows if isinstance(row, ast.Tuple) and index < len(row.elts)
                ]
                return frozenset().union(*found) if found else FACT
        return FACT

    def _iterated(self, target: ast.AST, held: ast.AST, name: str) -> Iterator[Texts]:
        match target:
            case ast.Name(id=found) if found == name:
                yield self._elements(held) if isinstance(held, ast.Tuple | ast.List) else FACT
            case ast.Tuple(elts=targets):
                for index, one in enumerate(targets):
                    if any(isinstance(inner, ast.Name) and inner.id == name for inner in ast.walk(one)):
                        yield self._column(held, index)

    def _given(self, name: str, function: ast.FunctionDef | ast.AsyncFunctionDef) -> Texts | None:
        """What the calls of a function give for a parameter, and its default; None for no parameter."""
        placed = [*function.args.posonlyargs, *function.args.args]
        named = [*placed, *function.args.kwonlyargs]
        if name not in [argument.arg for argument in named]:
            return None
        names = [argument.arg for argument in placed]
        method = bool(names) and names[0] in ("self", "cls")
        called = function.name
        if called == "__init__":
            owner = [one for one in self.package.classes.values() if function in one.body]
            called = owner[0].name if owner else ""
        texts: set[str] = set()
        defaults = dict(zip(reversed(names), reversed(function.args.defaults), strict=False))
        defaults |= {
            argument.arg: value
            for argument, value in zip(function.args.kwonlyargs, function.args.kw_defaults, strict=True)
            if value is not None
        }
        if name in defaults:
            texts |= self.read(defaults[name])
        alone = len(self.package.functions[function.name]) == 1 or function.name == "__init__"
        for call in self.package.calls[called]:
            if not alone and not self._near(function, call):
                continue  # of another function with this name
            found = [keyword.value for keyword in call.keywords if keyword.arg == name]
            if not found and name in names:
                index = names.index(name) - method
                found = call.args[index : index + 1]
            if found:
                texts |= self.read(found[0])
        return frozenset(texts) if texts else FACT

    def _returned(self, call: ast.Call) -> Texts:
        name = _called(call)
        if name == "join" and ast.unparse(call.func).startswith("'\\n") and call.args:
            return self._lines(call.args[0])
        if name == "Say":
            return FACT  # which is translated where it is said
        if name in ("str", "join", "strip", "format", "replace") or name not in self.package.functions:
            return FACT
        functions = self.package.functions[name]
        if len(functions) > 1:
            functions = [one for one in functions if self.package.path_of[id(one)] == self.package.path_of[id(call)]]
        texts = [
            self.read(node.value)
            for function in functions
            for node in ast.walk(function)
            if isinstance(node, ast.Return) and self.package.function_of[id(node)] is function
        ]
        return frozenset().union(*texts) if texts else FACT

    def _lines(self, node: ast.AST) -> Texts:
        """The texts of a list whose elements become lines."""
        match node:
            case ast.List(elts=elements) | ast.Tuple(elts=elements):
                return frozenset().union(*map(self._lines, elements))
            case ast.ListComp(elt=element) | ast.GeneratorExp(elt=element):
                return self.read(element)
            case ast.Starred(value=inside):
                return self._lines(inside)
            case ast.Call(func=ast.Name(id="filter"), args=[_, inside]):
                return self._lines(inside)
            case ast.Name(id=name):
                function = self.package.function_of[id(node)]
                values = [
                    each.value
                    for each in ast.walk(function)
                    if isinstance(each, ast.Assign) and ast.unparse(each.targets[0]) == name
                ]
                return frozenset().union(*map(self._lines, values)) if values else FACT
        return self.read(node)


def _is_class(package: Package, name: str) -> bool:
    """Whether what is raised is a class under another name, such as `refused`, and neither a function nor a bug."""
    return name not in package.functions and name not in ("TypeError", "ValueError", "KeyError", "IndexError")


def _class_of(package: Package, node: ast.AST) -> str:
    """The class in whose method a node stands."""
    function = package.function_of[id(node)]
    return next((name for name, made in package.classes.items() if function in made.body), "")


def _is_said(call: ast.Call, package: Package) -> bool:
    """Whether a call notes something of a flight, or says how far an export is."""
    match call.func:
        case ast.Name("say"):
            return bool(call.args)
        case ast.Attribute(ast.Attribute(attr="notes"), "append" | "insert"):
            return "flight" in package.path_of[id(call)].parts
    return False


def _shown(package: Package) -> Iterator[ast.AST]:
    """The expressions that become messages."""
    for name in LISTED:
        for node in ast.walk(package.classes[name]):
            if isinstance(node, ast.Return) and getattr(package.function_of[id(node)], "name", "") == "__str__":
                yield node.value
    for table in itertools.chain(*map(package.constants.__getitem__, TABLES)):
        yield from table.values if isinstance(table, ast.Dict) else [table]
    for name, calls in list(package.calls.items()):
        for call in calls:
            inherited = name == "__init__" and _class_of(package, call) in package.errors
            if inherited or name in package.errors or (id(call) in package.raised and _is_class(package, name)):
                yield from call.args[:1]
            if _is_said(call, package):
                yield call.args[-1]
            if name in SAID:
                yield from call.args[SAID[name] : SAID[name] + 1]
            yield from (keyword.value for keyword in call.keywords if keyword.arg in PARTS)


@cache
def found() -> dict[str, str]:
    """Every template of the package, and where it is said."""
    package = Package()
    reader = Reader(package)
    texts: dict[str, str] = {}
    for node in _shown(package):
        place = f"{package.path_of[id(node)].relative_to(PACKAGE)}:{node.lineno}"
        for text in reader.read(node):
            texts.setdefault(text, place)
    parts = {
        " ".join(part.split()): place
        for text, place in (reader.nested | texts).items()
        for line in text.split("\n")
        for part in PART.split(line)[::2]
    }
    return {part: place for part, place in parts.items() if worded(part)}


def helped() -> Iterator[tuple[str, str]]:
    """Every sentence and word of the help of a command, and the command."""
    from upright.cli.help import GROUPS
    from upright.cli.main import group

    yield from ((heading, "upright") for heading in GROUPS)
    commands = group()
    for name, command in [("upright", commands), *commands.commands.items()]:
        subcommands = list(getattr(command, "commands", {}).items()) if name != "upright" else []
        for own, each in [(name, command), *((f"{name} {sub}", one) for sub, one in subcommands)]:
            texts = (each.help or "").split("\n\n") + [p.help or "" for p in each.params]
            for text in texts:
                for sentence in re.split(r"(?<=\.) (?=[A-Z])", " ".join(text.split())):
                    if sentence:
                        yield sentence, own


def missing(here: Mapping[str, str]) -> dict[str, str]:
    """Every message that a catalogue lacks, and where it is said."""
    return {text: place for text, place in found().items() if text not in here}


def left_over(here: Mapping[str, str]) -> list[str]:
    """What a catalogue has and nothing says; a sentence of help may have a template, for its numbers."""
    helped_by = {sentence for sentence, _ in helped()}
    others = here.keys() - found().keys() - helped_by
    return sorted(text for text in others if not any(map(pattern(text).fullmatch, helped_by)))


if __name__ == "__main__":
    for language in set(LANGUAGES) - {ENGLISH}:
        own = sections(language)["here"]
        print(*(f"missing {place}\t{text}" for text, place in missing(own).items()), sep="\n")
        with speaking(language):
            unsaid = [text for text, _ in helped() if worded(text) and in_language(text) == text]
        print(*(f"missing in help\t{text}" for text in unsaid), sep="\n")
        print(*(f"left over\t{text}" for text in left_over(own)), sep="\n")
