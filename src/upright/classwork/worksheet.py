"""The worksheet of a class, as Markdown: what to do, what to ask oneself, and what to hand in."""

from __future__ import annotations

from urllib.parse import urlencode

from upright.classwork.tasks import TASKS, Task
from upright.errors import UnknownName
from upright.lab.codec import plain
from upright.lab.messages import Setup

LAB = "http://127.0.0.1:8765/"
"""Where `upright lab` answers."""

_WORDS = {
    "es": (
        "# Hoja de trabajo: un robot que se equilibra\n\n*Para estudiantes.*",
        "Abra el laboratorio (`upright lab`, o la dirección que muestra su docente). Cada tarea empieza con un enlace "
        "que prepara el robot. Si el laboratorio está en otra dirección, como en una clase, el enlace no lo abre. "
        "Entonces copie el enlace y pegue la parte que empieza con `#` al final de la dirección de su laboratorio.",
        "Tarea", "Preparar la tarea", "Haga", "Piense", "Respuesta",
        "## Qué se entrega",
        "Para cada tarea: presione *Poner de pie* y haga lo que se pide en menos de un minuto, sin cambiar nada más. "
        "Después, en *Guardar*, escriba su nombre y presione *Entregar*. El archivo contiene la configuración y lo que "
        "usted hizo; con `upright grade`, otro computador repite el ensayo. No modifique el archivo: se nota. Entregue "
        "los archivos y esta hoja con sus respuestas.",
    ),
    "en": (
        "# Worksheet: a robot that balances\n\n*For students.*",
        "Open the lab (`upright lab`, or the address that your teacher shows). Each task begins with its link, which "
        "sets the robot up. Where the lab has another address, as in a class, the link does not open it. Then copy "
        "the link, and paste the part that begins with `#` at the end of your lab's address.",
        "Task", "Set up task", "Do", "Think", "Answer",
        "## What to hand in",
        "For each task: press *Stand up*, do what is asked within a minute and without any other change, then *Keep* → "
        "*Hand in* under your name. The file holds the set-up and what you did; `upright grade` runs it again on "
        "another machine. Do not change it: that is noticed. Hand in the files, and this sheet with your answers.",
    ),
}  # fmt: skip

LANGUAGES = tuple(_WORDS)


def worksheet(language: str, lab: str = LAB) -> str:
    """The worksheet in Spanish ("es") or English ("en"), with links to the `lab` at that address."""
    if language not in _WORDS:
        raise UnknownName("language", language, LANGUAGES)
    title, start, task, link, do, think, answer, heading, ending = _WORDS[language]
    parts = [title, start]
    for number, one in enumerate(TASKS, 1):
        name, what, question = one.texts[language]
        lines = [
            f"[{link} {number}]({lab.split('#', maxsplit=1)[0]}{fragment(one)})",
            f"**{do}.** {what}",
            f"**{think}.** {question}",
            f"{answer}: " + "_" * 60,
        ]
        parts += [f"## {task} {number}: {name}", *lines]
    return "\n\n".join([*parts, heading, ending]) + "\n"


def fragment(task: Task) -> str:
    """The part of a link that sets the lab up for a task: robot, controller, and what differs from the usual set-up."""
    usual = plain(Setup())
    own = plain(task.setup)
    shown = {name: own[name] for name in own if name in ("robot", "controller") or own[name] != usual[name]}
    texts = {name: ",".join(map(_text, v)) if isinstance(v, list) else _text(v) for name, v in shown.items()}
    return "#" + urlencode(texts, safe=",")


def _text(value: str | float) -> str:
    return value if isinstance(value, str) else f"{value:g}"
