"""attributes: layer, colour and linetype of entities, with BYLAYER and BYBLOCK resolved.

If an entity names a layer that the layer table of the file does not contain, the layer is assumed
to have colour 7 and linetype Continuous, and to be neither off nor frozen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, NamedTuple

from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.visibility import LayerState, insert_on_layer, object_on_layer
from knifetip.dxf.encoding import unescape
from knifetip.messages import Message

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities.dxfgfx import DXFGraphic

#: Linetype of entities that do not specify a linetype.
BYLAYER: Final = "BYLAYER"
_BYBLOCK = 0
_BYLAYER = 256


class Layer(NamedTuple):
    """Colour, linetype and visibility of a layer of a DXF file.

    An entity whose colour or linetype is BYLAYER has the colour or linetype of its layer.
    """

    colour: int
    true_colour: int
    linetype: str
    state: LayerState


#: Attributes of a layer that is not in the layer table.
_UNLISTED = Layer(7, -1, "Continuous", LayerState())
#: Style of BYBLOCK entities outside of blocks.
_SHEET = Style("0", 7, -1, "Continuous")


def layer_of(colour: int, true_colour: int | None, linetype: str, flags: int, plot: int) -> Layer:
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
    """
    # A negative colour means that the layer is off; 0 has no meaning.
    state = LayerState(off=colour < 0, frozen=bool(flags & 1), plotted=plot != 0)
    return Layer(_index(abs(colour)), _rgb(true_colour), linetype, state)


def layers_of(document: Document) -> dict[str, Layer]:
    """Return the layers of an ezdxf document, by their names in lower case."""
    return {
        unescape(str(layer.dxf.get("name", ""))).lower(): layer_of(
            int(layer.dxf.get("color", 7)),
            layer.dxf.get("true_color"),
            unescape(str(layer.dxf.get("linetype", "Continuous"))),
            int(layer.dxf.get("flags", 0)),
            int(layer.dxf.get("plot", 1)),
        )
        for layer in document.layers
    }


class Styles:
    """Finds the style (layer, colour, linetype) of each entity of one file."""

    def __init__(self, layers: dict[str, Layer]) -> None:
        self._layers = layers

    def hidden(self, layer: str) -> Message | None:
        """Return the reason for leaving out an object on the layer ``layer``, None if visible."""
        return object_on_layer(layer, self._of(layer).state)

    def hidden_insert(self, layer: str) -> Message | None:
        """Return the reason for leaving out an INSERT on the layer ``layer`` with its content.

        None if the layer does not hide all content of the block.
        """
        return insert_on_layer(self._of(layer).state)

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
            insert_style,
        )

    def style(
        self,
        name: str,
        written: int,
        true: int | None,
        linetype: str,
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
        insert_style
            Style of the INSERT that places the entity, None in model space.  An entity whose colour
            or linetype is BYBLOCK gets the colour or linetype of the INSERT.  If an entity
            in a block is on layer 0, it gets the layer of the INSERT.
        """
        block = insert_style or _SHEET
        if insert_style is not None and name == "0":
            name = insert_style.layer
        layer = self._of(name)
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
        return Style(name, colour, true_colour, linetype)

    def _of(self, layer: str) -> Layer:
        return self._layers.get(layer.lower(), _UNLISTED)


def _index(colour: int) -> int:
    return colour if 1 <= colour <= 255 else 7


def _rgb(value: int | None) -> int:
    # In some files the upper byte contains the method by which the colour was chosen.
    return -1 if value is None else int(value) & 0xFFFFFF
