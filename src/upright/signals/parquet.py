"""Logs as Parquet: one column of doubles for each channel, units and origin in the metadata of the schema."""

from __future__ import annotations

from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from upright.arrays import Array, floats_of
from upright.errors import InvalidLog
from upright.signals.header import TIME, Columns, assemble, check_names, check_size, check_twice, describe, understand

_NOTE = b"upright-log"


def write(log: Columns, stream: BinaryIO) -> None:
    """Write columns `t` [s] and the channels, each with its unit in the metadata of its field."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    columns = log.table()
    units = {TIME: "s", **log.units}
    fields = [pa.field(name, pa.float64(), nullable=False, metadata={"unit": units[name]}) for name in columns]
    schema = pa.schema(fields, metadata={_NOTE: describe(log)})
    table = pa.table([pa.array(values) for values in columns.values()], schema=schema)
    pq.write_table(table, stream, compression="zstd", write_page_checksum=True)


def read(path: Path) -> Columns:
    """Read numeric columns, with or without our metadata; null is NaN. Raises `InvalidLog`."""
    table = table_of(path)
    check_names(table.column_names)
    columns = {name: _numbers(name, table.column(name)) for name in table.column_names}
    note = (table.schema.metadata or {}).get(_NOTE)
    units, origin = understand(note) if note is not None else (_field_units(table.schema), {})
    return assemble(columns, units, origin)


def table_of(path: Path) -> Any:
    """The table in a Parquet file, each column under its own name; raises `InvalidLog`."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        # Not read_table, which would add columns for folders that are called like `robot=2`.
        with pq.ParquetFile(path, page_checksum_verification=True) as file:
            check_size(file.metadata.num_rows, file.metadata.num_columns)
            check_twice(file.schema_arrow.names)
            return file.read()
    except (pa.ArrowException, OSError, UnicodeDecodeError, MemoryError) as error:
        raise InvalidLog(
            f"the Parquet cannot be read ({error})",
            likely="a file that was cut off, or another kind of file under this name",
            hint="copy it again from where it was recorded",
        ) from None


def _field_units(schema: Any) -> dict[str, str]:
    units = {field.name: (field.metadata or {}).get(b"unit") for field in schema}
    return {name: unit.decode(errors="replace") for name, unit in units.items() if unit is not None}


def _numbers(name: str, column: Any) -> Array:
    import pyarrow as pa

    kind = column.type
    if pa.types.is_integer(kind) or pa.types.is_floating(kind) or pa.types.is_decimal(kind) or pa.types.is_null(kind):
        return floats_of(column)
    valid = column.is_valid().to_numpy()
    row = int(np.argmax(valid)) if len(valid) else 0
    holds = f"'{column[row]}' at row {row}" if len(valid) else "no rows"
    raise InvalidLog(f"column '{name}' is {kind}: {holds}", expected="numbers", hint="convert or drop the column")
