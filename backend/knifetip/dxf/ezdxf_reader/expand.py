"""expand: replace the INSERTs of an ezdxf document by the entities of their blocks.

The result is the import report, with rows in file order, and the shapes with their placements.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterable
from functools import partial

import numpy as np
from ezdxf.document import Drawing as Document
from ezdxf.entities.dxfentity import DXFEntity

from knifetip.drawing_builder.report import ReportWriter
from knifetip.dxf.attributes import Styles, layers_of
from knifetip.dxf.ezdxf_reader.block_expansion import (
    Block,
    BlockExpansion,
    Entry,
    PlacedShape,
    unused_block_reason,
)
from knifetip.dxf.ezdxf_reader.ezdxf_entity import EzdxfEntity
from knifetip.dxf.ezdxf_reader.prescan import Prescan, PrescannedEntity
from knifetip.formats.limits import Limits

#: A prescanned entity, its handle in the report, and the ezdxf entity, if there is one.
_Pair = tuple[PrescannedEntity, str, DXFEntity | None]


def expand(
    document: Document, prescan: Prescan, limits: Limits, scale: float
) -> tuple[ReportWriter, list[PlacedShape]]:
    """Return the import report and the placed shapes of an ezdxf document.

    ``prescan`` contains the entities and blocks of the file as written, before ezdxf changed them.
    ``scale`` is the length of a file unit in mm, 0 while the unit is unknown.

    Raises
    ------
    DrawingTooLarge
        INSERTs are nested deeper, or expand to more entities, than the limits allow.
    """
    on_sheet = _match(prescan.entities, list(document.modelspace()), paper=False)
    blocks: dict[str, Block] = {}
    for key, block in prescan.blocks.items():
        layout = document.blocks.get(block.name) if block.name else None
        if layout is None or layout.block is None:
            continue
        base = layout.block.dxf.get("base_point", (0.0, 0.0, 0.0))
        pairs = _match(block.entities, list(layout), paper=True)
        blocks[key] = Block(
            block.name,
            np.array([float(base[0]), float(base[1])]),
            bool(layout.block.is_xref),
            len(pairs),
            _references(pairs),
            partial(_entries, pairs),
        )
    styles = Styles(layers_of(document))
    expansion = BlockExpansion(blocks, _references(on_sheet), styles, limits, scale)
    for entry in _entries(on_sheet):
        expansion.sheet_entity(entry)
    for key, block in prescan.blocks.items():
        if key not in expansion.used and block.entities:
            reason = unused_block_reason(block.name, len(block.entities))
            expansion.sheet.row(block.handle or block.name, "BLOCK", block.layer, reason)
    return expansion.sheet, expansion.placed


def _references(pairs: Iterable[_Pair]) -> list[tuple[str, int]]:
    """Return for each INSERT the lower-case name of its block and how many copies it places.

    ``pairs`` contains entities as written in the file with their ezdxf entities.  Entities of other
    kinds, and INSERTs that ezdxf skipped, are left out.
    """
    return [
        EzdxfEntity(entity).repeats()
        for counted, _, entity in pairs
        if counted.kind == "INSERT" and entity is not None
    ]


def _entries(pairs: Iterable[_Pair]) -> list[Entry]:
    return [
        Entry(counted, handle, None if entity is None else EzdxfEntity(entity))
        for counted, handle, entity in pairs
    ]


def _match(
    counted: list[PrescannedEntity], entities: list[DXFEntity], *, paper: bool
) -> list[_Pair]:
    """Return each entity as written in the file, with its handle and the matching ezdxf entity.

    Entities match if their kinds and handles are equal.  The remaining entities are paired in file
    order with remaining ezdxf entities of their kind, or with None if there are no more.  An entity
    that ezdxf contains and the file does not is appended, with a new ``PrescannedEntity`` made from
    it.

    ``paper``: whether ``entities`` include entities in paper space.  If False, entities of
    ``counted`` in paper space are matched only by kind and handle.
    """
    by_handle: dict[tuple[str, str], deque[DXFEntity]] = defaultdict(deque)
    for entity in entities:
        by_handle[entity.dxftype(), str(entity.dxf.get("handle", "")).upper()].append(entity)
    matches: dict[int, DXFEntity] = {}
    for number, one in enumerate(counted):
        if one.handle and (same := by_handle.get((one.kind, one.handle))):
            matches[number] = same.popleft()
    matched = {id(entity) for entity in matches.values()}
    by_kind: dict[str, deque[DXFEntity]] = defaultdict(deque)
    for entity in entities:
        if id(entity) not in matched:
            by_kind[entity.dxftype()].append(entity)
    pairs: list[_Pair] = []
    for number, one in enumerate(counted):
        partner = matches.get(number)
        if (
            partner is None
            and (paper or not one.in_paper_space)
            and (same := by_kind.get(one.kind))
        ):
            partner = same.popleft()
        pairs.append((one, one.handle or f"#{number + 1}", partner))
    # Entities that only ezdxf found are added.
    for entity in (entity for unmatched in by_kind.values() for entity in unmatched):
        dxf = entity.dxf
        extra = PrescannedEntity(
            entity.dxftype(), "", str(dxf.get("layer", "0")), in_paper_space=False
        )
        pairs.append((extra, str(dxf.get("handle", "")) or f"#{len(pairs) + 1}", entity))
    return pairs
