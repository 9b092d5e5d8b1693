"""What the names of columns say, in the words of other programs: a channel, a side, a unit."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from upright.signals import SIDES
from upright.signals.header import TIME

GYRO = "sensor/gyro"
OTHER_GYRO = "gyro across"
"""A gyro about the axis that other mountings turn forward: pitch where no column is about the usual one."""

BOTH, RATE = "both of ", "rate of "
"""Before the beginning of two channels, or a channel: what one column says of both sides, or the rate of."""

_ENCODER = (
    r"(?:(?:enc|encoder|cnt|counts?|ticks?|steps?|tacho|pos|angle|wheels?|rueda|motor|theta|phi|alpha|dist(?:ance)?"
    r"|travel|odom) ?"
    r"|(?:enc|count|tick|tacho|pos|rot|motor)\w* )"
)
_WHEEL = (
    r"(?:(?:actual|measured|raw|total) )?"
    r"(?:enc\w*|cnt|count\w*|tick\w*|steps?|tacho\w*|pos\w*|rot\w*|angle|wheel|rueda|motor\w*|theta|phi|alpha"
    r"|dist\w*|travel\w*|odom\w*)"
)
_SPEED = r"speed|spd|vel\w*|omega|rpm"
_RATE = rf"(?:{_SPEED}|w)"
_DRIVEN = r"pwm|duty(?: cycle)?|volt\w*|cmd|command|control(?: signal)?|output|torque|power|mando|tensi[oó]n"
_COMMAND = rf"\b(?:(?:mot\w* )?(?:{_DRIVEN}|u|tau))"
_LAW = r"(?:pid|lqr|control(?:ler)?|balance|motor)"
_COMMANDS = f"{BOTH}command/"
_NEITHER = (
    r"\b(?:current|curr|amps?|corriente|temp\w*|target|set ?points?|desired|goal|ref\w*|err\w*)\b"
    rf"|\b{_RATE} (?:cmd|command)\b|\b(?:cmd|command) {_RATE}\b"
)
"""What is no reading and no voltage or torque of a motor, whatever else its name says."""
_MOTOR = r"\bmotor ?(?:l|left|r|right|[1-4a-d])\b|\b(?:l|left|r|right) motor\b"  # an angle; beside encoders, a command
_TIME = r"t|time\w*|ts|clock|elapsed|tiempo|hora|fecha|date"
_BODY_RATE = (
    r"(?:pitch|tilt|theta|psi|body)[ _]?(?:rate|dot|dt|vel|speed)|\bd ?(?:pitch|tilt|theta|psi)\b"
    r"|^d?angle (?:rate|dot|dt|vel\w*|speed)(?: (?:rad|deg|dps)\b.*)?$|^d ?angle$"
    r"|(?:gyro|\bgyr|gir[oó](?:sc[oó]pio)?)(?! (?:x|z|off\w*|bias|temp\w*)\b)(?: (?:y|raw|rate|spd|speed))?\b|\bg ?y\b"
    r"|angular (?:velocity|rate) y\b"
)
_PER_SECOND = (
    rf"\b(?:{_SPEED}|rate|cps|pps|tps|sps)\b"
    r"|\b(?:counts?|ticks?|pulses?|steps?|turns?|m ?deg|deg\w*|rad\w*)? ?(?:per|p) s(?:ec\w*)?\b"
    r"|\b(?:counts?|ticks?|pulses?|m?deg|rad) s(?:ec)?\b"
)
"""What makes a rate of the wheels' angle that the rest of a name says: speed, rpm, ticks per second."""
_ESTIMATED = r"(?:comp\w*|kal\w*|kf|cf|filt\w*|fused|fusion|mahony|madgwick|imu|body|robot)"
_ANGLE = rf"^(?:{_ESTIMATED} )?angle(?: (?:rad|deg\w*|x10|est\w*|now|{_ESTIMATED}))*$"
"""The angle of a balancing robot, where no wheel or motor is named, is its tilt."""
SIDE_WORDS = {"left": r"(?:l|left|izq\w*)", "right": r"(?:r|right|der(?:echa|echo)?)"}

_WORDS: Sequence[tuple[str, str]] = (
    *((rf"^(?!.*\b{_RATE}\b)(?=.*\b(?:{_DRIVEN})\b).*\b{s}\b|^m {s}$", f"command/{n}") for n, s in SIDE_WORDS.items()),
    (rf"{_ENCODER}{SIDE_WORDS['left']}\b|\b{SIDE_WORDS['left']} ?{_WHEEL}", "sensor/encoder_left"),
    (rf"{_ENCODER}{SIDE_WORDS['right']}\b|\b{SIDE_WORDS['right']} ?{_WHEEL}", "sensor/encoder_right"),
    *((rf"\b{_RATE} ?{s}\b|\b{s} {_RATE}\b", f"{RATE}sensor/encoder_{name}") for name, s in SIDE_WORDS.items()),
    *((rf"{_COMMAND} ?{s}\b|\b{s} {_COMMAND}\b", f"command/{name}") for name, s in SIDE_WORDS.items()),
    (
        r"(?<!\bd )\b(?:pitch|tilt|lean|inclin\w*)(?: (?:rad|deg|x10|est\w*|angle|[xyz]))*$|gyro ?(?:ang\w*|est\w*)",
        "estimate/pitch",
    ),
    (_BODY_RATE, GYRO),
    (_ANGLE, "estimate/pitch"),
    (r"gyro x\b|\bg ?x\b", OTHER_GYRO),
    (r"\bbat\w*|\bvbat\w*|\bvcc\b", "sensor/battery"),
    (r"\b(?:heading|compass|yaw)(?: (?:rad|deg))?$", "sensor/compass"),
    (r"^(?:d ?t|delta ?t(?:ime)?|loop ?time|time ?(?:step|diff))\b", f"{RATE}{TIME}"),
    (rf"^(?:{_TIME}|seconds|secs?|millis|micros|[mun]s)\b|\b(?:time ?stamp|stamp)$", TIME),
    (r"^(?:enc\w*|cnt|counts?|tacho\w*|wheel|motor)(?: (?:angle|pos\w*|rad|deg|mean))*$", f"{BOTH}sensor/encoder_"),
    (rf"^(?:{_LAW} )?{_COMMAND}(?: (?:v|m ?v|volts?|percent|m|n?nm|mnm|mean|out(?:put)?|value|signal))*$", _COMMANDS),
    (rf"^{_LAW} out$", _COMMANDS),
)
"""Names of our channels in other programs, the more specific first; one encoder or command stands for both sides."""

_SUFFIXES: Sequence[tuple[str, str]] = (
    (r"\bm(?:dps| ?deg(?:ps| s|s))\b", "mdeg/s"), (r"\brad(?:ians?)? ?(?:p|per)? ?s(?:ec)?\b", "rad/s"),
    (r"\bdeg(?:rees?)? ?(?:p|per)? ?s(?:ec)?\b|\bdps\b", "deg/s"), (r"\bm ?deg\b", "mdeg"), (r"\bm ?rad\b", "mrad"),
    (r"\bdeg(?:rees?)?\b", "deg"), (r"\brad(?:ians?)?\b", "rad"), (r"mv\b|\bm v\b", "mV"),
    (r"\b(?:ms|millis)\b", "ms"), (r"\b(?:us|micros)\b", "us"), (r"\bns\b", "ns"), (r"\bm ?nm\b", "mN m"),
    (r"\bn?nm\b", "N m"), (r"pwm\b|\b(?:pwm|duty|percent|power)", "%"), (r"\brpm\b", "rpm"),
    (r"\b(?:turns?|revs?|revolutions?)\b", "turn"), (r"\bmm ?(?:p|per)? ?s(?:ec)?\b", "mm/s"), (r"\bmm\b", "mm"),
    (r"\bcm ?(?:p|per)? ?s(?:ec)?\b", "cm/s"), (r"\bcm\b", "cm"), (r"\b(?:torque|tau)\b", "N m"), (r"\bvolt", "V"),
)  # fmt: skip

_BY_UNIT = {
    "sensor/encoder_": ("deg", "rad", "turn", "mdeg", "mrad", "m", "cm", "mm"),
    f"{RATE}sensor/encoder_": ("deg/s", "rad/s", "rpm", "mdeg/s", "m/s", "cm/s", "mm/s"),
    "command/": ("V", "mV", "%", "N m", "mN m"),
}
"""What a column of one side holds by its unit alone."""

_ENDS = (("left", "right"), ("l", "r"), ("izq", "der"), ("izquierda", "derecha"))
_PORTS = (("1", "2"), ("a", "b"), ("b", "c"), ("a", "d"))
_PORTED = r"\b(?:enc|mot|m|pwm|wheel|tick|count|cnt|tacho|pos|duty|power|volt|cmd)"
"""How two columns of one kind differ. Numbers and letters are motor ports, of which the first is taken for the left."""


def plain(column: str) -> str:
    """`motorAngleLeft_deg` → `motor angle left deg`."""
    apart = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", re.sub("[°º]", " deg ", column))
    return re.sub(r"\bmot\b", "motor", re.sub(r"[_\W]+", " ", apart).lower().strip())


def is_motor(column: str) -> bool:
    """Whether a name says a motor's side and no more: its angle or, beside encoders, its command."""
    return bool(re.search(_MOTOR, plain(column)))


def recognised(columns: Sequence[str]) -> dict[str, str]:
    """The channel of each column whose name says one, in the order of the columns."""
    channels = {column: _channel(words) for column, words in _with_axes(columns).items()}
    silent = [column for column in columns if not channels[column] or channels[column].startswith(BOTH)]
    for left, right in pairs(silent):
        for column, side, words in zip((left, right), SIDES, _sided(plain(left), plain(right)) or (), strict=True):
            unit = unit_by_name(column)
            by_words = "" if words.split()[-1] == "w" else _channel(words)  # a wheel, or omega
            by_unit = "" if channels[column] else next((g + side for g, units in _BY_UNIT.items() if unit in units), "")
            channels[column] = by_unit or by_words or channels[column]
    return {column: name for column, name in channels.items() if name}


def _with_axes(columns: Sequence[str]) -> dict[str, str]:
    """The words of each column, those of a vector, numbered 0, 1 and 2, with its axes: `gyro 1` is `gyro y`."""
    words = {column: plain(column) for column in columns}
    vectors = {
        stem
        for stem, _, last in (name.rpartition(" ") for name in words.values())
        if last == "2" and {f"{stem} 0", f"{stem} 1"} <= {*words.values()} and f"{stem} 3" not in words.values()
    }
    axes = {f"{stem} {i}": f"{stem} {axis}" for stem in vectors for i, axis in enumerate("xyz")}
    return {column: axes.get(name, name) for column, name in words.items()}


def _channel(words: str) -> str:
    """The channel that words say; the rate of a wheel's angle where they say that too."""
    if re.search(_NEITHER, words):
        return ""
    name = _by_words(words)
    if not re.search(_PER_SECOND, words):
        return name
    of = name or _by_words(" ".join(re.sub(_PER_SECOND, " ", words).split()))
    if of.startswith(("sensor/encoder_", f"{BOTH}sensor/encoder_")):
        return RATE + of
    speed = name.removeprefix(BOTH).startswith("command/")  # of an inner loop, and no voltage
    return "" if speed else name or (GYRO if of == "estimate/pitch" else "")


def _by_words(words: str) -> str:
    return next((name for pattern, name in _WORDS if re.search(pattern, words)), "")


def pairs(columns: Iterable[str]) -> list[tuple[str, str]]:
    """The columns whose names differ by the side alone, the left one first."""
    left_over = list(columns)
    several = list[tuple[str, str]]()
    while left_over:
        column = left_over.pop(0)
        for other in left_over:
            one = next((p for p in ((column, other), (other, column)) if _sided(*map(plain, p))), None)
            if one:
                several.append(one)
                left_over.remove(other)
                break
    return several


def _sided(left: str, right: str) -> tuple[str, str] | None:
    """Two names in words with "left" and "right" for what differs between them; None where that is no side."""
    one, other = left.split(), right.split()
    different = [i for i, (a, b) in enumerate(zip(one, other, strict=False)) if a != b]
    if len(one) != len(other) or len(different) != 1:
        return None
    (i,) = different
    for a, b in (*_ENDS, *(_PORTS if re.search(_PORTED, left) else ())):
        if one[i].endswith(a) and other[i] == one[i].removesuffix(a) + b:
            stem = one[i].removesuffix(a)
            first = False
        elif one[i].startswith(a) and other[i] == b + one[i].removeprefix(a):
            stem = one[i].removeprefix(a)
            first = True
        else:
            continue
        new = (f"{side} {stem}" if first else f"{stem} {side}" for side in SIDES)
        left, right = (" ".join([*one[:i], *words.split(), *one[i + 1 :]]) for words in new)
        return left, right
    return None


_DIRECTION = r"\b(?:dir\w*|sign|fwd|forward|sentido)\b"


def direction_of(command: str, columns: Iterable[str]) -> str:
    """The column that says which way a command acts: the words left of both names are the same, or it is the only
    one; '' without any."""

    def left(column: str) -> str:
        return " ".join(re.sub(rf"{_DIRECTION}|\b(?:{_DRIVEN})\b", " ", plain(column)).split())

    ways = [column for column in columns if re.search(_DIRECTION, plain(column)) and column != command]
    return next((way for way in ways if left(way) == left(command)), ways[0] if len(ways) == 1 else "")


def unit_by_name(column: str) -> str:
    """The unit that a name ends in or says, '' where it says none."""
    if re.search(r"(?:[_\s(\[]|^)V\)?\]?$", column):
        return "V"
    if metres := re.search(r"[(\[]m(?:et(?:er|re)s?)?(/s)?[)\]]$", column):
        return f"m{metres[1] or ''}"
    words = plain(column)
    return next((unit for pattern, unit in _SUFFIXES if re.search(pattern, words)), "")


def by_letter(gyro: str, columns: Iterable[str]) -> bool:
    """Whether a column was taken for the gyro for a Greek letter alone, while there is one with the other letter too:
    pitch is ψ to some and θ to others, and the other letter then is yaw or a wheel."""
    letters = {letter for column in columns for letter in ("psi", "theta") if letter in plain(column).split()}
    words = plain(gyro).removeprefix("d").split()
    return len(letters) == 2 and words[0] in letters
