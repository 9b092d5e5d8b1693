"""Labelled results: an xarray `Dataset` with units in its attributes, saved as Parquet or Zarr, whole or not at all."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from upright.arrays import Array
from upright.atomic import filling, place_of, writing
from upright.errors import InvalidLog, UprightError, require
from upright.fleets.binomial import Interval, clopper_pearson
from upright.fleets.ensemble import OUTCOMES, Ensemble, Index
from upright.fleets.influence import Influence, influence
from upright.reading import expanded, understood
from upright.robots import PARAMETERS
from upright.robots.drives import EFFORT_UNITS
from upright.robots.uncertainty import Family
from upright.signals import parquet

if TYPE_CHECKING:
    from xarray import Dataset


_NOTE = b"upright-fleet"


@dataclass(frozen=True)
class Summary:
    """Statistics of a fleet: `fell` of `n` robots fell; the probability of a fall with its bounds; and the 5, 50 and
    95 % quantiles of each outcome over the robots that stood, in `units`; and which varied number the falls, or
    without enough of them the largest pitch, follow."""

    n: int
    fell: int
    chance: Interval
    quantiles: Mapping[str, tuple[float, float, float]]
    units: Mapping[str, str]
    influence: Influence

    def to_json(self) -> dict[str, Any]:
        """The same as JSON; NaN, where no robot stood, is null."""
        quantiles = {
            name: dict(zip(("q05", "q50", "q95"), (None if np.isnan(q) else q for q in row), strict=True))
            for name, row in self.quantiles.items()
        }
        return {"n": self.n, "fell": self.fell, "chance": self.chance._asdict(), "outcomes": quantiles,
                "influence": asdict(self.influence) | {"strongest": self.influence.strongest}}  # fmt: skip


def summarise(data: Dataset) -> Summary:
    """The summary of a fleet's results (dimension `robot`); without a push nothing settles."""
    fell = data["fell"].values.astype(bool)
    pushed = bool(origin_of(data).get("scenario", {}).get("push"))
    others = ("fell", "lived") if pushed else ("fell", "lived", "settling")
    names = [name for name in OUTCOMES if name in data and name not in others]
    quantiles = {name: _quantiles(data[name].values[~fell]) for name in names}
    units = {name: str(data[name].attrs["unit"]) for name in names}
    count = int(fell.sum())
    follows = influence(data, "fell" if count >= ENOUGH else "peak_pitch")
    return Summary(len(fell), count, clopper_pearson(count, len(fell)), quantiles, units, follows)


ENOUGH = 10  # falls: from fewer no cause is named


def _quantiles(values: Array) -> tuple[float, float, float]:
    finite = values[~np.isnan(values)]
    low, middle, high = np.quantile(finite, (0.05, 0.5, 0.95)).tolist() if len(finite) else (np.nan,) * 3
    return low, middle, high


def labelled(columns: Mapping[str, Array], index: Index, ensemble: Ensemble) -> Dataset:
    """Results of `Ensemble.run` for the robots number `index`, with captions, units and origin."""
    import xarray as xr

    family = ensemble.family
    units = {name: unit_of(name, family) for name in family.names} | {n: u for n, (u, _) in OUTCOMES.items()}
    units["effort"] = EFFORT_UNITS[family.robot.command_unit]
    words = {name: caption.template for name, (_, caption) in OUTCOMES.items()}
    variables = {
        name: ("robot", values, {"unit": units[name], "long_name": words.get(name, name)})
        for name, values in columns.items()
    }
    origin = json.dumps(ensemble.origin(), ensure_ascii=False)
    return xr.Dataset(variables, {"robot": np.asarray(index, dtype=np.int64)}, {"origin": origin})


def unit_of(name: str, family: Family) -> str:
    """The unit of a varied number: a parameter's, or a kit's by dotted name ("" for a sensor's)."""
    if name in PARAMETERS:
        return PARAMETERS[name][0]
    units = {"delay": "s", "jitter": "s", "battery.voltage": "V", "battery.sag": "1", "motor.backlash": "rad"}
    units |= dict.fromkeys(("motor.limit", "motor.dead_zone", "motor.quantum"), family.robot.command_unit)
    return units.get(name, "")


def origin_of(data: Dataset) -> dict[str, Any]:
    """Origin of a result: robot, controller and its hash, scenario, seed, versions."""
    return json.loads(data.attrs.get("origin", "{}"))


def save(data: Dataset, path: str | Path) -> Path:
    """Write as `.parquet` (a table, one row a point) or `.zarr` (a folder of arrays), by the suffix; returns the path.

    Raises `UprightError` for another suffix or where it cannot be written, `MissingTool` where Zarr is not installed.
    """
    target = Path(os.path.expanduser(path))
    check_suffix(target)
    if target.suffix == ".zarr":
        return _save_zarr(data, target)
    with writing(target) as stream:
        write_parquet(data, stream)
    return target


def load(path: str | Path) -> Dataset:
    """A dataset that `save` wrote; raises `InvalidLog` for any other file."""
    source = expanded(path, InvalidLog)
    check_suffix(source)
    if not source.exists():
        raise InvalidLog(f"there is no {source}", expected="a result of upright fleet, push-map, basin or sweep")
    return _load_zarr(source) if source.suffix == ".zarr" else _load_parquet(source)


def check_target(path: Path) -> None:
    """Raise `UprightError` where no result can be saved: a folder that is no result is never replaced."""
    check_suffix(path)
    place = place_of(path, folder=path.suffix == ".zarr")
    if path.suffix == ".zarr" and place.exists() and not (place / ".zgroup").exists():
        raise UprightError(f"{path} is something else", expected="nothing there, or a result in Zarr")


def check_suffix(path: Path) -> None:
    """Raise `UprightError` for a name that ends neither in .parquet nor in .zarr."""
    if path.suffix not in (".parquet", ".zarr"):
        raise UprightError(f"{path.name} has no known format", expected="a name that ends in .parquet or .zarr")
    if path.suffix == ".zarr":
        require("a result as .zarr", "zarr")


def write_parquet(data: Dataset, stream: BinaryIO) -> None:
    """One row for each point of all dimensions; units with the columns, shape and origin with the schema."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    sizes = {str(name): int(size) for name, size in data.sizes.items()}
    named = {str(name): data[name] for name in (*data.coords, *data.data_vars)}
    fields = [pa.field(name, _arrow(v.dtype), metadata={"attrs": json.dumps(v.attrs)}) for name, v in named.items()]
    shapes = {name: [str(d) for d in v.dims] for name, v in named.items()}
    note = {"sizes": sizes, "dims": shapes, "coords": [str(c) for c in data.coords], "attrs": data.attrs}
    columns = [pa.array(_spread_out(v.values, shapes[name], sizes), type=_arrow(v.dtype)) for name, v in named.items()]
    schema = pa.schema(fields, metadata={_NOTE: json.dumps(note).encode()})
    pq.write_table(pa.table(columns, schema=schema), stream, compression="zstd", write_page_checksum=True)


def _arrow(kind: np.dtype[Any]) -> Any:
    import pyarrow as pa

    return pa.string() if kind.kind in "UO" else pa.from_numpy_dtype(kind)


def _spread_out(values: NDArray[Any], dims: Sequence[str], sizes: Mapping[str, int]) -> NDArray[Any]:
    """The values at every point of all dimensions, as one column."""
    shape = [sizes[name] if name in dims else 1 for name in sizes]
    order = [dims.index(name) for name in sizes if name in dims]
    return np.broadcast_to(values.transpose(order).reshape(shape), tuple(sizes.values())).reshape(-1)


def _load_parquet(path: Path) -> Dataset:
    table = parquet.table_of(path)
    with understood(f"{path} as a fleet's result", InvalidLog, "Parquet by upright"):
        return _dataset(table, json.loads((table.schema.metadata or {})[_NOTE]))


def _dataset(table: Any, note: Any) -> Dataset:
    import pyarrow as pa
    import xarray as xr

    sizes: dict[str, int] = note["sizes"]
    read: dict[str, Any] = {}
    for column in table.schema:
        dims = [name for name in sizes if name in note["dims"][column.name]]
        values = np.asarray(table.column(column.name).to_numpy()).reshape(tuple(sizes.values()))
        first = tuple(slice(None) if name in dims else 0 for name in sizes)
        kind = str if pa.types.is_string(column.type) else values.dtype
        read[column.name] = (dims, values[first].astype(kind), json.loads(column.metadata[b"attrs"]))
    coords = {name: read.pop(name) for name in note["coords"]}
    return xr.Dataset(read, coords, note["attrs"])


def _save_zarr(data: Dataset, target: Path) -> Path:
    """Format 2, since 3 has no settled form of texts."""
    check_target(target)
    with filling(target, folder=True) as folder:
        data.to_zarr(folder, mode="w", consolidated=False, zarr_format=2)
    return target


def _load_zarr(path: Path) -> Dataset:
    import xarray as xr

    try:
        with xr.open_zarr(path, consolidated=False, chunks=None) as data:
            return data.load()
    except (OSError, ValueError, KeyError) as error:
        raise InvalidLog(
            f"{path} cannot be read ({type(error).__name__}: {error})", expected="Zarr by upright"
        ) from None
