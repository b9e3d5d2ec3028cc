"""attributes: layer, colour, linetype and line width of entities, BYLAYER and BYBLOCK resolved.

If an entity names a layer that the layer table of the file does not contain, the layer is assumed
to have colour 7, linetype Continuous and no line width, and to be neither off nor frozen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, NamedTuple

from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.line_widths import GREATEST
from knifetip.drawing_builder.visibility import LayerState, insert_on_layer, object_on_layer
from knifetip.dxf.encoding import unescape
from knifetip.messages import Message
from knifetip.model.drawing import NO_LINE_WIDTH

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities.dxfgfx import DXFGraphic

#: Linetype of entities that do not specify a linetype.
BYLAYER: Final = "BYLAYER"
_BYBLOCK = 0
_BYLAYER = 256
#: Line widths (group 370) that refer to the layer, to the INSERT, and to a setting of the program.
WIDTH_BYLAYER: Final = -1
_WIDTH_BYBLOCK: Final = -2
_WIDTH_DEFAULT: Final = -3


class Layer(NamedTuple):
    """Colour, linetype, line width and visibility of a layer of a DXF file.

    An entity whose colour, linetype or line width is BYLAYER has that of its layer.
    """

    colour: int
    true_colour: int
    linetype: str
    state: LayerState
    line_width: int = NO_LINE_WIDTH


#: Attributes of a layer that is not in the layer table.
_UNLISTED = Layer(7, -1, "Continuous", LayerState())
#: Style of BYBLOCK entities outside of blocks.
_SHEET = Style("0", 7, -1, "Continuous")


def layer_of(
    colour: int,
    true_colour: int | None,
    linetype: str,
    flags: int,
    plot: int,
    line_width: int = _WIDTH_DEFAULT,
) -> Layer:
    """Return the layer for a row of the layer table of a file, given the values in this row.

    Parameters
    ----------
    colour
        Colour index; negative if the layer is off.
    true_colour
        True colour 0xRRGGBB, None if the row has none.
    linetype
        Name of the linetype of the layer.
    flags
        Value of group code 70; its lowest bit is set if the layer is frozen.
    plot
        0 if the layer is not plotted.
    line_width
        Line width (1/100 mm); negative if the row states none.
    """
    # A negative colour means that the layer is off; 0 has no meaning.
    state = LayerState(off=colour < 0, frozen=bool(flags & 1), plotted=plot != 0)
    width = line_width if line_width >= 0 else NO_LINE_WIDTH
    return Layer(_index(abs(colour)), _rgb(true_colour), linetype, state, width)


def layers_of(document: Document) -> dict[str, Layer]:
    """Return the layers of an ezdxf document, by their names in lower case."""
    return {
        unescape(str(layer.dxf.get("name", ""))).lower(): layer_of(
            int(layer.dxf.get("color", 7)),
            layer.dxf.get("true_color"),
            unescape(str(layer.dxf.get("linetype", "Continuous"))),
            int(layer.dxf.get("flags", 0)),
            int(layer.dxf.get("plot", 1)),
            limited_width(layer.dxf.get("lineweight", _WIDTH_DEFAULT)),
        )
        for layer in document.layers
    }


def limited_width(written: int) -> int:
    """Return a value of group 370, limited to the greatest line width."""
    return min(int(written), GREATEST)


class Styles:
    """Finds the style (layer, colour, linetype, line width) of each entity of one file."""

    def __init__(self, layers: dict[str, Layer]) -> None:
        self._layers = layers

    def hidden(self, layer: str) -> Message | None:
        """Return the reason for leaving out an object on the layer ``layer``, None if visible."""
        return object_on_layer(layer, self._find_layer(layer).state)

    def hidden_insert(self, layer: str) -> Message | None:
        """Return the reason for leaving out an INSERT on the layer ``layer`` with its content.

        None if the layer does not hide all content of the block.
        """
        return insert_on_layer(self._find_layer(layer).state)

    def entity_style(self, entity: DXFGraphic, insert_style: Style | None = None) -> Style:
        """Return the style of an ezdxf entity.

        ``insert_style`` is the style of the INSERT that places the entity, None in model space.
        """
        dxf = entity.dxf
        return self.style(
            unescape(str(dxf.get("layer", "0"))),
            dxf.get("color", _BYLAYER),
            dxf.true_color if dxf.hasattr("true_color") else None,
            unescape(str(dxf.get("linetype", BYLAYER))),
            limited_width(dxf.get("lineweight", WIDTH_BYLAYER)),
            insert_style,
        )

    def style(
        self,
        name: str,
        written: int,
        true: int | None,
        linetype: str,
        line_width: int = WIDTH_BYLAYER,
        insert_style: Style | None = None,
    ) -> Style:
        """Return the style of an entity from its own attributes, its layer and its INSERT.

        Parameters
        ----------
        name
            Name of the layer of the entity.
        written
            Colour index of the entity as written; 256 (BYLAYER) if the entity has none.
        true
            True colour 0xRRGGBB of the entity; None if the entity has none.
        linetype
            Name of the linetype of the entity; "BYLAYER" if the entity has none.
        line_width
            Line width of the entity (1/100 mm) or −1 (BYLAYER), −2 (BYBLOCK) or −3 (the default of
            the program); −1 if the entity has none.
        insert_style
            Style of the INSERT that places the entity, None in model space.  An entity whose
            colour, linetype or line width is BYBLOCK gets that of the INSERT.  If an entity in a
            block is on layer 0, it gets the layer of the INSERT.
        """
        block = insert_style or _SHEET
        if insert_style is not None and name == "0":
            name = insert_style.layer
        layer = self._find_layer(name)
        if written == _BYLAYER:
            colour, true_colour = layer.colour, layer.true_colour
        elif written == _BYBLOCK:
            colour, true_colour = block.colour, block.true_colour
        else:
            colour, true_colour = _index(written), -1
        if true is not None:
            true_colour = _rgb(true)
        if linetype.upper() == BYLAYER:
            linetype = layer.linetype
        elif linetype.upper() == "BYBLOCK":
            linetype = block.linetype
        if line_width == _WIDTH_BYBLOCK:
            line_width = block.line_width
        elif line_width == _WIDTH_DEFAULT:
            line_width = NO_LINE_WIDTH
        elif line_width < 0:
            line_width = layer.line_width
        return Style(name, colour, true_colour, linetype, line_width)

    def _find_layer(self, layer: str) -> Layer:
        return self._layers.get(layer.lower(), _UNLISTED)


def _index(colour: int) -> int:
    return colour if 1 <= colour <= 255 else 7


def _rgb(value: int | None) -> int:
    # In some files the upper byte contains the method by which the colour was chosen.
    return -1 if value is None else int(value) & 0xFFFFFF
