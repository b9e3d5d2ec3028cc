"""expand: a document of ezdxf, walked through entity by entity.

document, census -> ReportWriter: ledger rows in file order, and what is drawn with its placements
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
from knifetip.dxf.census import Census, Counted
from knifetip.dxf.single import ByEzdxf
from knifetip.dxf.walk import Block, Entry, Placed, Walk, idle
from knifetip.formats.limits import Limits

#: An entity as counted, its name in the ledger, and as ezdxf read it, if it did.
_Pair = tuple[Counted, str, DXFEntity | None]


def expand(document: Document, census: Census, limits: Limits) -> tuple[ReportWriter, list[Placed]]:
    """Return the ledger's rows and the placed shapes of a document.

    Raises
    ------
    DrawingTooLarge
        INSERTs are nested deeper, or stand for more entities, than the limits allow.
    """
    on_sheet = _matched(census.entities, list(document.modelspace()), paper=False)
    blocks: dict[str, Block] = {}
    for key, block in census.blocks.items():
        layout = document.blocks.get(block.name) if block.name else None
        if layout is None or layout.block is None:
            continue
        base = layout.block.dxf.get("base_point", (0.0, 0.0, 0.0))
        pairs = _matched(block.entities, list(layout), paper=True)
        blocks[key] = Block(
            block.name,
            np.array([float(base[0]), float(base[1])]),
            bool(layout.block.is_xref),
            len(pairs),
            _references(pairs),
            partial(_entries, pairs),
        )
    walk = Walk(blocks, _references(on_sheet), Styles(layers_of(document)), limits)
    for entry in _entries(on_sheet):
        walk.sheet_entity(entry)
    for key, block in census.blocks.items():
        if key not in walk.used and block.entities:
            why = idle(block.name, len(block.entities))
            walk.sheet.row(block.handle or block.name, "BLOCK", block.layer, why)
    return walk.sheet, walk.placed


def _references(pairs: Iterable[_Pair]) -> list[tuple[str, int]]:
    """Return the blocks that INSERTs refer to, each with how often it repeats them."""
    return [
        ByEzdxf(entity).repeats()
        for counted, _, entity in pairs
        if counted.kind == "INSERT" and entity is not None
    ]


def _entries(pairs: Iterable[_Pair]) -> list[Entry]:
    return [
        Entry(counted, handle, None if entity is None else ByEzdxf(entity))
        for counted, handle, entity in pairs
    ]


def _matched(counted: list[Counted], entities: list[DXFEntity], *, paper: bool) -> list[_Pair]:
    """Pair what the file has with what ezdxf read: by handle, else in order of their kind.

    Parameters
    ----------
    paper
        What is marked as of paper space is among the entities.
    """
    by_handle: dict[tuple[str, str], deque[DXFEntity]] = defaultdict(deque)
    for entity in entities:
        by_handle[entity.dxftype(), str(entity.dxf.get("handle", "")).upper()].append(entity)
    found: dict[int, DXFEntity] = {}
    for number, one in enumerate(counted):
        if one.handle and (same := by_handle.get((one.kind, one.handle))):
            found[number] = same.popleft()
    taken = {id(entity) for entity in found.values()}
    by_kind: dict[str, deque[DXFEntity]] = defaultdict(deque)
    for entity in entities:
        if id(entity) not in taken:
            by_kind[entity.dxftype()].append(entity)
    pairs: list[_Pair] = []
    for number, one in enumerate(counted):
        partner = found.get(number)
        if partner is None and (paper or not one.paper) and (same := by_kind.get(one.kind)):
            partner = same.popleft()
        pairs.append((one, one.handle or f"#{number + 1}", partner))
    # What ezdxf found where the count saw nothing is not lost either.
    for entity in (entity for left in by_kind.values() for entity in left):
        dxf = entity.dxf
        extra = Counted(entity.dxftype(), "", str(dxf.get("layer", "0")), paper=False)
        pairs.append((extra, str(dxf.get("handle", "")) or f"#{len(pairs) + 1}", entity))
    return pairs
