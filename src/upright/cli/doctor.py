"""`upright doctor`: faults of a log and their repair."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.cli.destination import Destination
from upright.cli.output import print_json, refuse_existing, tell
from upright.progress import progress


def doctor(
    log: Path,
    *,
    mapping: str | None = None,
    robot: Annotated[
        str | None, "Robot by name (see `upright robots`) or TOML file; improves the checks of units."
    ] = None,
    fix: Path | None = None,
    write_mapping: Path | None = None,
    out: Destination,
) -> None:
    """Find faults of a log: units, signs, delays, bias, …

    Prints each finding with its evidence and repair. Exit code 0, whatever the findings.
    """
    from dataclasses import replace

    from upright.atomic import write_text
    from upright.checkup.columns import drafted, to_complete
    from upright.checkup.doctor import doctor as examine
    from upright.errors import InvalidLog
    from upright.logs.readers import read_table
    from upright.signals.files import check_format

    out.check(fix, write_mapping, logs=[log])
    check_format(fix)
    refuse_existing(write_mapping)
    table = read_table(log)
    try:
        with progress("examining") as show:
            diagnosis = examine(table, robot, mapping=mapping, progress=show)
    except InvalidLog as error:
        if not write_mapping or mapping:
            raise
        write_text(write_mapping, drafted(table))
        if out.json:
            print_json({"draft": str(write_mapping)})
        else:
            tell(f"{error}\na draft is in {write_mapping}")
        return
    repaired = diagnosis.repaired().save(fix) if fix else None
    mapped = write_text(write_mapping, to_complete(diagnosis.mapping, diagnosis.findings)) if write_mapping else None
    # as it was typed, for what to run next
    own = write_mapping or (mapping if mapping and mapping.endswith(".toml") else "")
    diagnosis = replace(diagnosis, source=str(log), mapped=str(own), saved=str(fix or ""))
    out.finish(diagnosis, repaired, mapped)
