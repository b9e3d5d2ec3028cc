"""tables: decoded names, layers, handles and blocks of a scanned DXF file.

Each name is decoded and checked once, and not for every entity that uses it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from knifetip.drawing_builder.columns import Style
from knifetip.dxf.attributes import BYLAYER, Layer, Styles, layer_of
from knifetip.dxf.encoding import encoding_of, unescape
from knifetip.dxf.ezdxf_reader.prescan import header_of
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.handle_set import handles_of
from knifetip.dxf.fast_reader.scan import Scan
from knifetip.geometry.columns import I64
from knifetip.messages import Message

#: Characters that DXF does not allow in names; ezdxf reads such files.
_NOT_IN_NAMES: Final = frozenset('<>/\\":;?*=`|,\ufffd')
#: Kinds of records that are not entities.  ezdxf refuses a file with such a record among its
#: entities, but accepts unknown kinds there.
NO_ENTITIES: Final = {
    "ACDBDICTIONARYWDFLT", "ACDBPLACEHOLDER", "APPID", "BLOCK", "BLOCK_RECORD", "CLASS",
    "DGNDEFINITION", "DICTIONARY", "DICTIONARYVAR", "DIMSTYLE", "DWFDEFINITION", "ENDBLK",
    "FIELDLIST", "GEODATA", "GROUP", "IDBUFFER", "IMAGEDEF", "IMAGEDEF_REACTOR", "LAYER",
    "LAYER_FILTER", "LAYOUT", "LTYPE", "MATERIAL", "MLEADERSTYLE", "MLINESTYLE", "PDFDEFINITION",
    "PLOTSETTINGS", "RASTERVARIABLES", "SORTENTSTABLE", "SPATIAL_FILTER", "STYLE", "SUN", "TABLE",
    "UCS", "VBA_PROJECT", "VIEW", "VISUALSTYLE", "VPORT", "WIPEOUTVARIABLES", "XRECORD",
}  # fmt: skip
_VERSIONS: Final = (
    *("", "AC1002", "AC1003", "AC1004", "AC1006", "AC1009", "AC1012", "AC1014"),
    *("AC1015", "AC1018", "AC1021", "AC1024", "AC1027", "AC1032"),
)


class Unsupported(Exception):
    """Raised if the fast reader does not support a file; ``dxf.read`` then reads it with ezdxf."""


class Tables:
    """Decoded names, layers, handles and blocks of one scanned file.

    Raises
    ------
    Unsupported
        A name, a handle, a block or the DXF version is not supported.
    """

    def __init__(self, scanned: Scan) -> None:
        self.scan = scanned
        low, high = scanned.header
        self.variables = header_of(scanned.data[low:high])
        version = self.variables.get("$ACADVER", "")
        if version not in _VERSIONS:
            raise Unsupported
        self.version = version or "AC1009"
        self.encoding = encoding_of(scanned.data, self.variables)
        self.names = [name.decode(self.encoding, "replace") for name in scanned.names]
        self.words = self._words()
        self._check_names()
        self.styles = Styles(self._layers())
        # For each name, and at the end for layer 0 of entities without a layer: 0 if an object on
        # the layer of this name is visible, otherwise a number that identifies the reason.
        self.hidden = self._numbers_of_reasons(self.styles.hidden)
        self.hidden_inserts = self._numbers_of_reasons(self.styles.hidden_insert)
        handles = handles_of(scanned.data, scanned.entity, len(scanned.block), scanned.others)
        if handles is None:
            raise Unsupported
        self.handles = handles
        # First row and number of rows of each block; -1 is model space.
        blocks, first, size = np.unique(
            scanned.entity[:, f.BLOCK], return_index=True, return_counts=True
        )
        self.span: dict[int, tuple[int, int]] = {
            block: (low, rows)
            for block, low, rows in zip(blocks.tolist(), first.tolist(), size.tolist(), strict=True)
        }
        self.blocks = self._blocks()

    def layer(self, row: int) -> str:
        """Return the layer name, as written, of the entity in row ``row`` of ``Scan.entity``."""
        number = self.scan.entity[row, f.LAYER]
        return self.names[number] if number >= 0 else "0"

    def block_name(self, block: int) -> str:
        """Return the name, as written, of the block in row ``block`` of ``Scan.block``."""
        return self.names[int(self.scan.block[block, f.NAME])]

    def style(self, row: int, insert_style: Style | None = None) -> Style:
        """Return the style of the entity in row ``row`` of ``Scan.entity``.

        ``insert_style`` is the style of the INSERT that places the entity, None in model space.
        """
        line = self.scan.entity[row].tolist()
        true, linetype = line[f.TRUE_COLOUR], line[f.LINETYPE]
        return self.styles.style(
            self.layer(row),
            line[f.COLOUR],
            true if true >= 0 else None,
            self.names[linetype] if linetype >= 0 else BYLAYER,
            line[f.LINE_WIDTH],
            insert_style,
        )

    def _words(self) -> dict[int, str]:
        """Return the kinds of entities that the file contains, such as LINE.

        The keys of the dictionary are the indices of the kinds in the table of names.

        Raises ``Unsupported``: the name of a kind is not ASCII, not in upper case, or not the name
        of an entity.
        """
        column = self.scan.entity[:, f.WORD]
        words = {
            number: self.names[number] for number in np.flatnonzero(np.bincount(column)).tolist()
        }
        for word in words.values():
            if word != word.upper() or not word.isascii() or word in NO_ENTITIES:
                raise Unsupported
        return words

    def _check_names(self) -> None:
        entity, layer = self.scan.entity, self.scan.layer
        for column in (
            entity[:, f.LAYER],
            entity[:, f.LINETYPE],
            layer[:, f.LAYER_NAME],
            layer[:, f.LAYER_LINETYPE],
            self.scan.block[:, f.BLOCK_LAYER],
        ):
            for number in np.flatnonzero(np.bincount(column + 1)[1:]).tolist():
                name = self.names[number]
                if not name or not _NOT_IN_NAMES.isdisjoint(name) or unescape(name) != name:
                    raise Unsupported

    def _layers(self) -> dict[str, Layer]:
        table: dict[str, Layer] = {}
        for row in self.scan.layer.tolist():
            name = self.names[row[f.LAYER_NAME]].lower() if row[f.LAYER_NAME] >= 0 else ""
            if not name or name in table:
                raise Unsupported
            linetype, true = row[f.LAYER_LINETYPE], row[f.LAYER_TRUE]
            table[name] = layer_of(
                row[f.LAYER_COLOUR],
                true if true >= 0 else None,
                self.names[linetype] if linetype >= 0 else "Continuous",
                row[f.LAYER_FLAGS],
                row[f.LAYER_PLOT],
                row[f.LAYER_LINE_WIDTH],
            )
        return table

    def _numbers_of_reasons(self, reason: Callable[[str], Message | None]) -> I64:
        """Return for each name, and for layer 0 at the end, a number that identifies a reason.

        ``reason`` returns the reason for leaving out an object on a layer, None if it is visible.
        The number is 0 for None, and for names that no entity uses as a layer.
        """
        numbers: dict[Message | None, int] = {None: 0}
        result = np.zeros(len(self.names) + 1, np.int64)
        for layer in (np.flatnonzero(np.bincount(self.scan.entity[:, f.LAYER] + 1)) - 1).tolist():
            name = self.names[layer] if layer >= 0 else "0"
            result[layer] = numbers.setdefault(reason(name), len(numbers))
        return result

    def _blocks(self) -> dict[str, int]:
        """Return the row in ``Scan.block`` of each block definition, by block name in lower case.

        Raises ``Unsupported``: a block is external, has no name, has a name with special characters
        or a name that occurs twice, or contains the entities of a layout.
        """
        blocks: dict[str, int] = {}
        if self.scan.block[:, f.EXTERNAL].any():
            raise Unsupported
        for number, name in enumerate(self.scan.block[:, f.NAME].tolist()):
            key = self.names[name].lower() if name >= 0 else ""
            if not key or key in blocks or "\\" in key or "\ufffd" in key:
                raise Unsupported
            blocks[key] = number
            if key.startswith(("*model_space", "*paper_space")) and number in self.span:
                raise Unsupported
        return blocks
