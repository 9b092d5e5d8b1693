"""Logs as MCAP, to be opened in Foxglove and PlotJuggler.

The messages are JSON with a JSON Schema. Both programs plot these without a plug-in or a compiled message definition.
Foxglove needs message encoding `json`, schema encoding `jsonschema` and a schema of `"type": "object"`
(docs.foxglove.dev, "Custom schema encodings"). PlotJuggler picks its parser by the message encoding, and needs any
schema.

- A topic for each path of channels: `truth/pitch` is the field `pitch` of `/truth`. A name without a path is a topic
  of its own name with the field `value`. So is the time `t`, whose exact seconds the log time cannot hold.
- The log time is t in nanoseconds, rounded. MCAP has no negative time: a log that starts before zero has nanoseconds
  since its start.
- JSON has no NaN: it is `null`, a gap in the curve. It has no infinity either: that is the text "Infinity" or
  "-Infinity". The schema says `number` all the same, because Foxglove's reader of schemas refuses a list of types.
- Units and origin are in the metadata record `upright`.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from upright.arrays import Array
from upright.errors import InvalidLog
from upright.signals.header import TIME, Columns, assemble, check_names, describe, understand

_NOTE = "upright"
_VALUE = "value"
_SPECIAL = {"nan": "null", "inf": '"Infinity"', "-inf": '"-Infinity"'}
LARGEST = 512 << 20
"""[bytes] of messages in a file: some hours at a kilohertz."""

_LONGEST = 2**63  # [ns]: some readers keep the 64 bits of the log time with a sign


def write(log: Columns, stream: BinaryIO) -> None:
    """Write one message for each topic and sample; the same log gives the same bytes."""
    from mcap.writer import Writer

    ticks = _nanoseconds(log.t)
    # The checksum of the whole data section lets `read` find damage outside the chunks, such as in the metadata.
    writer = Writer(stream, enable_data_crcs=True)
    writer.start(library="upright")
    writer.add_metadata(_NOTE, {"log": describe(log)})
    topics = _topics(log)
    ids = [_register(writer, topic, fields, log.units) for topic, fields in topics.items()]
    messages = zip(*(_messages(fields) for fields in topics.values()), strict=True)
    for row, (tick, texts) in enumerate(zip(ticks, messages, strict=True)):
        for channel, text in zip(ids, texts, strict=True):
            writer.add_message(channel, log_time=tick, data=text.encode(), publish_time=tick, sequence=row)
    writer.finish()


def read(path: Path) -> Columns:
    """Read a log that `write` wrote. Raises `InvalidLog` for a broken file, or another program's recording."""
    note, topics = _contents(path)
    if note is None:
        raise InvalidLog(
            "the MCAP has no metadata record 'upright'",
            likely="a recording of another program",
            hint="export it as CSV with a column 't' in seconds",
        )
    units, origin = understand(note)
    check_names([TIME] if _address(TIME)[0] in topics else sorted(topics))
    return assemble({name: _column(name, topics) for name in (TIME, *units)}, units, origin)


def _address(name: str) -> tuple[str, str]:
    """Topic and field of a channel; no two channels share both."""
    path, slash, field = name.rpartition("/")
    return (f"/{path}", field) if slash else (name, _VALUE)


def _nanoseconds(t: Array) -> list[int]:
    ticks = np.rint((t - min(t[0], 0.0)) * 1e9)
    if not ticks[-1] < _LONGEST:
        longest = f"less than {_LONGEST / 1e9:.3g} s, as MCAP counts nanoseconds in 64 bits"
        raise InvalidLog(f"t goes from {t[0]:g} to {t[-1]:g} s", expected=longest, hint="save as .parquet or .csv")
    return [int(tick) for tick in ticks.tolist()]


def _topics(log: Columns) -> dict[str, dict[str, tuple[str, Array]]]:
    """Topic → field → (channel name, values)."""
    topics: dict[str, dict[str, tuple[str, Array]]] = {}
    for name, values in log.table().items():
        topic, field = _address(name)
        topics.setdefault(topic, {})[field] = name, values
    return topics


def _register(writer: Any, topic: str, fields: Mapping[str, tuple[str, Array]], units: Mapping[str, str]) -> int:
    units = {TIME: "s", **units}
    properties = {field: {"type": "number", "description": units[name]} for field, (name, _) in fields.items()}
    schema = {"title": topic, "type": "object", "properties": properties}
    schema_id = writer.register_schema(f"upright{topic}", "jsonschema", json.dumps(schema).encode())
    return writer.register_channel(topic, "json", schema_id)


def _messages(fields: Mapping[str, tuple[str, Array]]) -> Iterator[str]:
    keys = [json.dumps(field).replace("%", "%%") for field in fields]
    template = "{" + ", ".join(f"{key}: %s" for key in keys) + "}"
    texts = [map(_number, values.tolist()) for _, values in fields.values()]
    return (template % row for row in zip(*texts, strict=True))


def _number(value: float) -> str:
    text = repr(value)
    return _SPECIAL.get(text, text)


def _contents(path: Path) -> tuple[str | None, dict[str, list[dict[str, Any]]]]:
    try:
        with path.open("rb") as stream:
            note, messages = _records(stream)
        return note, {topic: json.loads(b"[" + b",".join(texts) + b"]") for topic, texts in messages.items()}
    except OSError:
        raise
    except Exception as error:  # whatever a parser of binary records stumbles over in damaged bytes
        raise InvalidLog(
            f"the MCAP cannot be read ({error or type(error).__name__})",
            likely="a recording that was cut off, or another kind of file under this name",
            hint="copy it again, or try 'mcap recover'",
        ) from None


def _records(stream: BinaryIO) -> tuple[str | None, dict[str, list[bytes]]]:
    """Our note, and the messages of each JSON topic in the order of the file."""
    from mcap.records import Channel, Message, Metadata
    from mcap.stream_reader import StreamReader

    note: str | None = None
    topics: dict[int, str] = {}
    messages: dict[str, list[bytes]] = {}
    left = LARGEST
    for record in StreamReader(stream, validate_crcs=True, record_size_limit=LARGEST).records:
        if isinstance(record, Message) and record.channel_id in topics:
            left -= len(record.data)
            if left < 0:
                raise ValueError(f"more than {LARGEST >> 20} MB of messages")
            messages[topics[record.channel_id]].append(record.data)
        elif isinstance(record, Channel) and record.message_encoding == "json":
            topics[record.id] = record.topic
            messages.setdefault(record.topic, [])
        elif isinstance(record, Metadata) and record.name == _NOTE:
            note = record.metadata["log"]
    return note, messages


def _column(name: str, topics: Mapping[str, Sequence[Mapping[str, Any]]]) -> Array:
    topic, field = _address(name)
    if topic not in topics:
        raise InvalidLog(f"the MCAP has no topic '{topic}' for channel '{name}'", likely="a recording that was edited")
    try:
        return np.array([message.get(field) for message in topics[topic]], dtype=np.float64)
    except (AttributeError, TypeError, ValueError):
        raise InvalidLog(f"channel '{name}' holds something else than numbers", expected="a number or null") from None
