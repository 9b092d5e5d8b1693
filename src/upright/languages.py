"""The language of what a notebook shows: words and numbers of figures and of tables, all of them here.

A figure is drawn once, in English; its words are replaced while it is shown. What `print` writes stays English.
"""

from __future__ import annotations

import functools
import os
import re
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from upright.errors import UnknownName

SPANISH = {
    # quantities, as the glossary of docs/conventions.md has them
    "time": "tiempo", "pitch": "inclinación", "pitch rate": "velocidad de inclinación", "wheel": "ángulo de las ruedas",
    "wheel rate": "velocidad de las ruedas", "yaw": "rumbo", "yaw rate": "velocidad de giro", "gyro": "giróscopo",
    "compass": "brújula", "encoders": "codificadores", "encoder left": "codificador izquierdo",
    "encoder right": "codificador derecho", "commands": "mandos", "left command": "mando izquierdo",
    "truth": "verdad", "applied": "aplicado",
    "right command": "mando derecho", "left": "izquierda", "right": "derecha", "battery": "batería",
    "wheel mass": "masa de una rueda", "wheel radius": "radio de la rueda", "wheel inertia": "inercia de una rueda",
    "body mass": "masa del cuerpo", "track": "ancho de vía", "centre of mass height": "altura centro de masa",
    "pitch inertia": "inercia de cabeceo", "yaw inertia": "inercia de guiñada", "roll inertia": "inercia de balanceo",
    "rotor inertia": "inercia del rotor", "gear ratio": "relación de transmisión",
    "motor resistance": "resistencia del motor", "back emf": "constante de fcem",
    "torque constant": "constante de par", "motor friction": "fricción del motor",
    "wheel friction": "fricción de la rueda", "Coulomb friction": "fricción de Coulomb",
    "rolling friction": "fricción de rodadura", "gravity": "gravedad",
    "stiction rate": "velocidad de suavizado", "body depth": "fondo del cuerpo", "body height": "altura del cuerpo",
    "speed lag": "retardo de la velocidad", "acceleration limit": "límite de aceleración",
    "slip torque": "par de deslizamiento",
    "{} delay": "retardo de {}",
    "delay": "retardo", "dead zone": "zona muerta",
    # bodies and runs
    "twin": "gemelo", "nonlinear": "no lineal", "linear": "lineal", "linear model": "modelo lineal",
    "nonlinear model": "modelo no lineal", "real robot": "robot real", "push": "empujón",
    "push acts": "actúa el empujón",
    "measured": "medido", "predicted": "predicho", "simulated freely": "simulado libremente",
    "push, not simulated": "empujón, sin simular", "lost": "perdido", "{}, error": "{}, error",
    "{}, measured − predicted": "{}, medido − predicho",
    "balancing": "en equilibrio", "standing still": "de pie, quieto",
    "lying": "caído", "upside down": "cabeza abajo", "standing up": "levantándose", "falling": "cayendo",
    "fallen": "tras caer", "moved": "movido", "cut": "corte",
    "at the limit": "en el límite", "held out: not fitted": "apartado: no se ajustó",
    "skill": "acierto",
    # a loop
    "magnitude": "magnitud", "phase": "fase", "frequency": "frecuencia", "loop gain": "ganancia de lazo",
    "gain 1 and phase ±180°: the point −1": "ganancia 1 y fase ±180°: el punto −1",
    "gain margins": "márgenes de ganancia", "phase margin": "margen de fase", "real part": "parte real",
    "imaginary part": "parte imaginaria", "loop gain L(jω)": "ganancia de lazo L(jω)",
    "negative frequencies": "frecuencias negativas", "distance 1 / Ms": "distancia 1 / Ms",
    "nearest to −1": "lo más cerca de −1",
    "unit circle: inside it a motion fades": "círculo unidad: dentro, un movimiento se apaga",
    "robots drawn from the spreads": "robots sorteados según la incertidumbre", "nominal robot": "robot nominal",
    "broken at": "cortado en", "gain": "ganancia", "disk": "disco", "poles": "polos",
    "left motor": "motor izquierdo", "right motor": "motor derecho", "both motors": "ambos motores",
    "steering": "giro", "# … #": "# … #", "# ms": "# ms", "# # ms": "# # ms", "# #j": "# #j",
    "{} on {}, every # ms": "{} sobre {}, cada # ms", "{} x + {} u, every # s": "{} x + {} u, cada # s",
    "{}: survives {}, and {} or {} of its gain.": "{}: soporta {}, y {} o {} de su ganancia.",
    "# ms more delay": "# ms más de retardo", "any delay": "cualquier retardo",
    "as weak as # %": "un mínimo del # %", "however weak": "cualquier mínimo",
    "as strong as # %": "un máximo del # %", "however strong": "cualquier máximo",
    "{}: unstable, so there is no margin.": "{}: inestable, por lo que no hay margen.",
    "With # ms more delay at {} it becomes unstable.": "Con # ms más de retardo en {} se vuelve inestable.",
    "With # ms more delay at the {} alone it becomes unstable.":
        "Con # ms más de retardo en un solo lugar ({}) se vuelve inestable.",
    "Both motors, varied independently: gains between # and # %, or phases up to #.":
        "Ambos motores, cada uno por su lado: ganancias entre # y # %, o fases hasta #.",
    "Of # simulated robots, as different as the robot's file allows, {}.":
        "De # robots simulados, tan distintos como permite su archivo, {}.",
    "none is unstable": "ninguno es inestable", "# is unstable": "# es inestable", "# are unstable": "# son inestables",
    "The loop is unstable: its largest pole is at |z| = #.":
        "El lazo es inestable: su mayor polo está en |z| = #.",
    "Parameters within their intervals (μ): the loop {}; {}.":
        "Parámetros dentro de sus intervalos (μ): el lazo {}; {}.",
    "is stable within # of the intervals": "es estable hasta # de los intervalos",
    "is always stable": "es siempre estable", "unstable at # of them": "inestable en # de ellos",
    "no unstable robot up to # of them": "ningún robot inestable hasta # de ellos",
    # parameters, methods
    "parameter": "parámetro", "estimate": "estimación", "95 % interval": "intervalo del 95 %",
    "95 % before this log": "95 % antes de este registro",
    "difference from the value before [its standard deviations]":
        "diferencia con el valor anterior [sus desviaciones típicas]",
    "unstable pole": "polo inestable", "true pole": "polo verdadero", "method": "método",
    "its regulator holds the robot": "su regulador lo sostiene", "its regulator does not": "su regulador no",
    "default": "por defecto", "chosen": "elegido", "others of the front": "otros del frente",
    "gain margin": "margen de ganancia",
    "largest knock survived": "mayor golpe soportado",
    # many robots
    "robots": "robots", "robots that fell": "robots que cayeron", "robots that fall": "robots que caen",
    "case": "caso", "controller": "controlador", "limit": "límite", "travel": "recorrido",
    "largest distance rolled": "mayor distancia recorrida", "largest pitch": "mayor inclinación",
    "stood for": "tiempo de pie", "settling time after the last push": "tiempo de asentamiento tras el último empujón",
    "RMS pitch": "inclinación RMS", "effort": "esfuerzo", "saturated fraction": "saturación", "fell": "se cayó",
    "all pushes together, at most (95 %)": "todos juntos, como máximo (95 %)",
    "hold at {}, {} battery": "sostener a {}, batería {}", "knock of {} N s, {} battery": "golpe de {} N s, batería {}",
    "hold at {}": "sostener a {}", "knock of {} N s": "golpe de {} N s", "full": "plena", "low": "baja",
    "# to #": "# a #",
    # tables
    "symbol": "símbolo", "value": "valor", "spread": "incertidumbre", "unit": "unidad", "source": "procedencia",
    "channel": "canal", "least": "mínimo", "largest": "máximo", "guess": "supuesto", "not stated": "no se declara",
    "{}: voltage drive, kit {}": "{}: mando de tensión, electrónica {}",
    "{}: torque drive, kit {}": "{}: mando de par, electrónica {}",
    "samples": "muestras", "its standard deviations": "sus desviaciones típicas",
}  # fmt: skip
"""English → Spanish; `{}` stands for a number or a name, which is translated too, `#` for a number alone."""

LANGUAGES = {"en": {}, "es": SPANISH}

ENGLISH = "en"

_words: dict[str, str] = {}
_language: ContextVar[str | None] = ContextVar("language", default=None)


def chosen() -> str:
    """The language of all text: that of `language` or `speaking`, else of UPRIGHT_LANG, else English."""
    asked = _language.get() or os.environ.get("UPRIGHT_LANG", "")[:2]
    return asked if asked in LANGUAGES else ENGLISH


@contextmanager
def speaking(name: str) -> Generator[None]:
    """Text is in this language as long as the block runs; raises `UnknownName`."""
    before = _language.set(_known(name))
    try:
        yield
    finally:
        _language.reset(before)


def language(name: str = ENGLISH, words: Mapping[str, str] | None = None) -> None:
    """From now on text is in English ("en") or Spanish ("es"), with its decimal comma.

    `words` of your own, such as names of runs in figures, go from English to that language. Raises `UnknownName` for
    another language.
    """
    _language.set(_known(name))
    _words.clear()
    _words.update(LANGUAGES[name], **(words or {}) if name != ENGLISH else {})
    _patterns.cache_clear()


def _known(name: str) -> str:
    if name not in LANGUAGES:
        raise UnknownName("language", name, list(LANGUAGES))
    return name


_NUMBER = r"[±+−-]? ?\d*\.?\d+(?:e[+-]?\d+)?(?: · 10[⁻⁰¹²³⁴-⁹]+)?(?: ?[%°])?"
_UNIT = re.compile(r"(.+) ([\[(].+[\])])")
_PLACE = re.compile(r"\{\}|#")


@functools.cache
def _patterns() -> list[tuple[re.Pattern[str], str]]:
    """What has a place for a number or a name, and its translation; longer ones first."""
    held = sorted((key for key in _words if _PLACE.search(key)), key=len, reverse=True)
    return [
        (
            re.compile(re.escape(key).replace(r"\{\}", "(.+)").replace(r"\#", f"({_NUMBER})")),
            _PLACE.sub("{}", _words[key]),
        )
        for key in held
    ]


def translated(text: str) -> str:
    """The text in the language that was chosen, or as it is: its words, then those before a unit or a bracket."""
    if text in _words or not _words:
        return _words.get(text, text)
    if re.fullmatch(_NUMBER, text):
        return text.replace(".", ",")
    for pattern, words in _patterns():
        if match := pattern.fullmatch(text):
            return words.format(*map(translated, match.groups()))
    if len(listed := text.split(", ")) > 1 and all(part in _words for part in listed):
        return ", ".join(map(translated, listed))
    if match := _UNIT.fullmatch(text):
        return f"{translated(match[1])} {match[2][0]}{translated(match[2][1:-1])}{match[2][-1]}"
    return text


@contextmanager
def figure_translated(figure: Any) -> Generator[None]:
    """A figure of matplotlib in the language that was chosen, as long as the block runs."""
    if not _words:
        yield
        return
    from matplotlib.text import Text

    english = [(text, text.get_text()) for text in figure.findobj(Text)]
    axes = [axis for ax in figure.axes for axis in (ax.xaxis, ax.yaxis)]
    ticks = {id(f): f for axis in axes for f in (axis.get_major_formatter(), axis.get_minor_formatter())}
    try:
        for text, words in english:
            text.set_text(translated(words))
        for each in ticks.values():
            each.format_ticks = functools.partial(_ticks, each.format_ticks)
        yield
    finally:
        for each in ticks.values():
            vars(each).pop("format_ticks", None)
        for text, words in english:
            text.set_text(words)


def _ticks(labels: Any, values: Any) -> list[str]:
    return [translated(label) for label in labels(values)]
