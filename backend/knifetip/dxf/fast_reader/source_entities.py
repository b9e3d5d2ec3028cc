"""source_entities: present scanned entities to ``BlockExpansion``, which expands them one by one.

Entities that the scan does not support are read with ezdxf.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from knifetip.drawing_builder.columns import Style
from knifetip.dxf.attributes import Styles
from knifetip.dxf.ezdxf_reader.block_expansion import Block, Entry, Reference
from knifetip.dxf.ezdxf_reader.entities import EntityShape, Lines, Undrawable
from knifetip.dxf.ezdxf_reader.place import refuse_after
from knifetip.dxf.ezdxf_reader.prescan import PrescannedEntity
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.import_report_writer import boxes, few_vertices_reason
from knifetip.dxf.fast_reader.scan import Scan
from knifetip.dxf.fast_reader.segments import EntitySegments
from knifetip.dxf.fast_reader.tables import Tables, Unsupported
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64, I64, Bool

if TYPE_CHECKING:
    from knifetip.dxf.ezdxf_reader.ezdxf_entity import EzdxfEntity


class SourceEntities:
    """The entities of one scanned file, for ``BlockExpansion``.

    Raises
    ------
    Unsupported
        ezdxf cannot read an entity that the scan does not support.
    """

    def __init__(
        self,
        scanned: Scan,
        tables: Tables,
        segments: EntitySegments,
        unsupported: Bool,
        limits: Limits,
    ) -> None:
        """Read the entities in the mask ``unsupported``, (e,), with ezdxf."""
        self.tables = tables
        self.segments = segments
        self.polyline_width: F64 = np.zeros(0)  #: (e,) set when the unit is known
        self._scan = scanned
        self._unsupported = self._read_unsupported(np.flatnonzero(unsupported), limits)

    def blocks(self) -> dict[str, Block]:
        """Return the block definitions, by their names in lower case."""
        definitions = {}
        inserts = np.flatnonzero(self._scan.entity[:, f.KIND] == f.INSERT)
        for key, number in self.tables.blocks.items():
            low, size = self.tables.span.get(number, (0, 0))
            nested = inserts[np.searchsorted(inserts, low) : np.searchsorted(inserts, low + size)]
            definitions[key] = Block(
                self.tables.block_name(number),
                self._scan.base[number],
                bool(self._scan.block[number, f.EXTERNAL]),
                size,
                [self.repeats(row) for row in nested.tolist()],
                partial(self._entries, range(low, low + size)),
            )
        return definitions

    def entry(self, row: int) -> Entry:
        """Return the entity in row ``row`` of ``Scan.entity``."""
        line = self._scan.entity[row]
        kind, handle = self.tables.words[int(line[f.WORD])], self.tables.handles[row]
        box = None if line[f.PAPER] else boxes(self.tables, np.array([row]))[0]
        layer, paper = self.tables.layer(row), bool(line[f.PAPER])
        counted = PrescannedEntity(kind, handle, layer, paper, box=box)
        return Entry(counted, handle, self._source_entity(row))

    def reference(self, row: int) -> Reference:
        """Return the block placement of the INSERT in row ``row`` of ``Scan.entity``."""
        line, value = self._scan.entity[row].tolist(), self._scan.value[row].tolist()

        def value_or(column: int, default: float) -> float:
            number: float = value[column]
            return default if np.isnan(number) else number

        return Reference(
            self.tables.names[line[f.REFERENCE]],
            line[f.MIRROR] != 0,
            (value[f.X], value[f.Y], 0.0),
            (value_or(f.SCALE_X, 1.0), value_or(f.SCALE_Y, 1.0)),
            value_or(f.ANGLE, 0.0),
            (max(line[f.COLUMNS], 1), max(line[f.ROWS], 1)),
            (value_or(f.SPACE_X, 0.0), value_or(f.SPACE_Y, 0.0)),
            clipped=False,
        )

    def repeats(self, row: int) -> tuple[str, int]:
        """Return the name in lower case, and the number of copies, of the block of an INSERT.

        ``row`` is the row of the INSERT in ``Scan.entity``.
        """
        return self._source_entity(row).repeats()

    def _read_unsupported(self, rows: I64, limits: Limits) -> dict[int, EzdxfEntity]:
        """Return the entities in ``rows``, which the scan does not support, read with ezdxf.

        The keys of the dictionary are the rows of the entities in ``Scan.entity``.
        """
        if not len(rows):
            return {}
        from knifetip.dxf.ezdxf_reader.ezdxf_entity import EntityReader  # imports ezdxf: slow

        singles = EntityReader(self.tables.version, self.tables.encoding)
        deadline = time.monotonic() + limits.seconds
        unsupported = {}
        for row in rows.tolist():
            refuse_after(deadline, limits)
            low, high = self._scan.entity[row, [f.START, f.END]].tolist()
            try:
                unsupported[row] = singles.read(self._scan.data[low:high])
            except Exception as damage:
                raise Unsupported from damage
        return unsupported

    def _source_entity(self, row: int) -> EzdxfEntity | _ScannedEntity:
        return self._unsupported.get(row) or _ScannedEntity(self, row)

    def _entries(self, rows: Iterable[int]) -> list[Entry]:
        return list(map(self.entry, rows))


class _ScannedEntity:
    """An entity of a scanned file that implements the interface ``SourceEntity``."""

    hidden = False

    def __init__(self, source: SourceEntities, row: int) -> None:
        self._source = source
        self._row = row

    def style(self, styles: Styles, insert_style: Style | None) -> Style:  # noqa: ARG002  # as SourceEntity.style
        # ``tables`` contains its own ``Styles`` of this file, equal to the argument.
        return self._source.tables.style(self._row, insert_style)

    def shape(self) -> EntityShape:
        if reason := few_vertices_reason(self._source.tables, self._row):
            raise Undrawable(reason)
        segments = self._source.segments
        low, high = segments.first[self._row : self._row + 2]
        shape = Lines(segments.ends[low:high], segments.bulge[low:high])
        return EntityShape(shape, line_width=float(self._source.polyline_width[self._row]))

    def reference(self) -> Reference:
        return self._source.reference(self._row)

    def repeats(self) -> tuple[str, int]:
        insert = self._source.reference(self._row)
        return insert.block.lower(), insert.cells[0] * insert.cells[1]
