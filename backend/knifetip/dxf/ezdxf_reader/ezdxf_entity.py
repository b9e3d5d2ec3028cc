"""ezdxf_entity: read single entities with ezdxf, and get their style, shape and placement.

The ezdxf reader uses this module for all entities, the fast reader for unsupported ones.
"""

from __future__ import annotations

import io
from typing import Any

from ezdxf.document import Drawing as Document
from ezdxf.entities import factory
from ezdxf.entities.ellipse import Ellipse, is_valid_ratio
from ezdxf.entities.subentity import entity_linker
from ezdxf.lldxf.const import DXFValueError
from ezdxf.lldxf.extendedtags import ExtendedTags
from ezdxf.lldxf.tagger import ascii_tags_loader, tag_compiler
from ezdxf.lldxf.tags import group_tags

from knifetip.drawing_builder.columns import Style
from knifetip.dxf.attributes import Styles
from knifetip.dxf.ezdxf_reader.block_expansion import Reference
from knifetip.dxf.ezdxf_reader.damaged_values import CHECKED, find_damaged_value
from knifetip.dxf.ezdxf_reader.entities import EntityShape, Undrawable, is_mirrored, shape_of
from knifetip.dxf.ezdxf_reader.rewrite import UNMARKED, with_markers
from knifetip.errors import NotADrawing
from knifetip.messages import Message


class EzdxfEntity:
    """An entity read with ezdxf that implements the interface ``block_expansion.SourceEntity``."""

    def __init__(self, entity: Any) -> None:
        self._entity = entity

    @property
    def hidden(self) -> bool:
        return bool(self._entity.dxf.get("invisible", 0))

    def style(self, styles: Styles, insert_style: Style | None) -> Style:
        return styles.entity_style(self._entity, insert_style)

    def shape(self) -> EntityShape:
        return shape_of(self._entity)

    def reference(self) -> Reference:
        dxf = self._entity.dxf
        if not dxf.hasattr("insert"):
            raise Undrawable(Message("import.incomplete", part="position"))
        x, y, z = dxf.insert
        return Reference(
            _block_name(self._entity),
            is_mirrored(self._entity),
            (float(x), float(y), float(z)),
            (float(dxf.get("xscale", 1.0)), float(dxf.get("yscale", 1.0))),
            float(dxf.get("rotation", 0.0)),
            _cells(self._entity),
            (float(dxf.get("column_spacing", 0.0)), float(dxf.get("row_spacing", 0.0))),
            _is_clipped(self._entity),
        )

    def repeats(self) -> tuple[str, int]:
        """Return the lower-case name of this INSERT's block, and the number of its copies."""
        columns, rows = _cells(self._entity)
        return _block_name(self._entity).lower(), columns * rows


def _block_name(insert: Any) -> str:
    """Return the name of the block that an INSERT places."""
    return str(insert.dxf.get("name", ""))


def _cells(insert: Any) -> tuple[int, int]:
    """Return the number of columns and of rows in which an INSERT places copies of its block."""
    dxf = insert.dxf
    return max(int(dxf.get("column_count", 1)), 1), max(int(dxf.get("row_count", 1)), 1)


def _is_clipped(insert: Any) -> bool:
    return bool(insert.has_extension_dict) and "ACAD_FILTER" in insert.get_extension_dict()


class EntityReader:
    """Reads entities of a file one at a time with ezdxf, each from its own bytes.

    ``version`` and ``encoding`` are the DXF version and the character encoding of the file.
    """

    def __init__(self, version: str, encoding: str) -> None:
        self._document = Document()
        self._document._dxfversion = version
        self._document.is_loading = True
        self._every = version <= UNMARKED
        self._encoding = encoding

    def read(self, data: bytes) -> EzdxfEntity:
        """Return the entity whose tags are in ``data``.

        The tags of a polyline are followed by the tags of its vertices.

        Raises
        ------
        Exception
            The entity is damaged, or ezdxf can read it only by recovering the whole file.  Any
            exception of ezdxf may be raised.
        """
        if damage := _damaged_value(data):
            raise damage
        # ezdxf looks for a z coordinate after each point, so at least one more tag must follow.
        ended = io.BytesIO(with_markers(data + b"0\nEOF\n", every=self._every))
        stream = io.TextIOWrapper(ended, encoding=self._encoding, errors="replace")
        linked = entity_linker()
        entities = [
            factory.load(ExtendedTags(tags), self._document)
            for tags in group_tags(tag_compiler(ascii_tags_loader(stream)))
        ]
        for entity in entities[:-1]:
            linked(entity)
        entity = entities[0]
        if isinstance(entity, Ellipse) and not is_valid_ratio(entity.dxf.ratio):
            raise DXFValueError(f"an ellipse of ratio {entity.dxf.ratio:g}")
        return EzdxfEntity(entity)


def _damaged_value(data: bytes) -> NotADrawing | None:
    """Return an error for the first value that ezdxf would change in the entity ``data``.

    The line number of the error counts from the start of the entity.
    """
    lines = data.split(b"\n")
    kind = lines[1].strip().decode("ascii", "replace")
    values = lines[1::2]
    codes = list(map(int, lines[0 : 2 * len(values) : 2]))
    return find_damaged_value(kind, codes, values) if kind in CHECKED else None
