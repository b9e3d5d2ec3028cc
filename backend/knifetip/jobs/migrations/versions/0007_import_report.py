"""Rename the import report, its outcomes and the figures of the verdict, in columns and in JSON."""

import json
import struct
import zlib
from collections.abc import Mapping
from typing import Any

import sqlalchemy as sa
from alembic import op

revision = "0007"
down_revision = "0006"
branch_labels = None
depends_on = None

#: Old and new keys of JSON objects and names of columns in blocks.
NAMES = {"ledger": "import_report", "fate": "outcome", "fates": "outcomes"}
#: Number of drawings read at a time.
BATCH = 20


def upgrade() -> None:
    op.alter_column("drawing", "ledger", new_column_name="import_report")
    op.alter_column("job", "judged", new_column_name="verdict_summary")
    _rename(NAMES)


def downgrade() -> None:
    _rename({new: old for old, new in NAMES.items()})
    op.alter_column("job", "verdict_summary", new_column_name="judged")
    op.alter_column("drawing", "import_report", new_column_name="ledger")


def _rename(names: Mapping[str, str]) -> None:
    """Rename keys in the summary, the import report and the edges of every drawing."""
    drawing = sa.table(
        "drawing",
        sa.column("serial", sa.BigInteger()),
        sa.column("summary", sa.JSON()),
        sa.column("edges", sa.LargeBinary()),
        sa.column("import_report", sa.LargeBinary()),
    )
    connection = op.get_bind()
    last = -1
    while rows := connection.execute(
        sa.select(drawing)
        .where(drawing.c.serial > last)
        .order_by(drawing.c.serial)
        .limit(BATCH)
    ).all():
        for serial, summary, edges, report in rows:
            connection.execute(
                sa.update(drawing)
                .where(drawing.c.serial == serial)
                .values(
                    summary=_renamed_keys(summary, names),
                    edges=_renamed_block(edges, names),
                    import_report=_renamed_report(report, names),
                )
            )
            last = serial


def _renamed_keys(data: Any, names: Mapping[str, str]) -> Any:
    """Return JSON data whose objects have the new keys at every depth."""
    if isinstance(data, dict):
        return {names.get(key, key): _renamed_keys(item, names) for key, item in data.items()}
    if isinstance(data, list):
        return [_renamed_keys(item, names) for item in data]
    return data


def _renamed_report(report: bytes, names: Mapping[str, str]) -> bytes:
    """Return a deflated import report with the new keys; one that is empty stays so."""
    if not report:
        return report
    rows = _renamed_keys(json.loads(zlib.decompress(report)), names)
    return zlib.compress(json.dumps(rows).encode(), 6)


def _renamed_block(block: bytes, names: Mapping[str, str]) -> bytes:
    """Return a block of columns with the new names; bytes of another format stay as they are.

    A block is ``KTIP``, the length of its header (uint32), the header as JSON padded to a multiple
    of 8 bytes, and the data, whose offsets count from the end of the header.
    """
    if block[:4] != b"KTIP" or len(block) < 8:
        return block
    (length,) = struct.unpack_from("<I", block, 4)
    header = json.loads(block[8 : 8 + length])
    columns = [
        {**column, "name": names.get(column["name"], column["name"])}
        for column in header["columns"]
    ]
    header = {"columns": columns, "meta": _renamed_keys(header["meta"], names)}
    text = json.dumps(header, ensure_ascii=False).encode("utf-8", "replace")
    text += b" " * (-(8 + len(text)) % 8)
    return block[:4] + struct.pack("<I", len(text)) + text + block[8 + length :]
