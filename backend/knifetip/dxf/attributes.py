"""attributes: the layer, colour and linetype that an entity really has.

    entity, style of the INSERT around it -> Style, with BYLAYER and BYBLOCK resolved

A layer that the file uses but does not define is colour 7, Continuous, on and thawed.
"""

from __future__ import annotations

from typing import NamedTuple

from ezdxf.document import Drawing as Document
from ezdxf.entities.dxfgfx import DXFGraphic

from knifetip.dxf.census import spelled

_BYBLOCK = 0
_BYLAYER = 256


class Style(NamedTuple):
    """What an entity is drawn with."""

    layer: str
    colour: int  #: AutoCAD colour index 1 … 255
    true_colour: int  #: 0xRRGGBB, -1 where there is none
    linetype: str


class _Layer(NamedTuple):
    colour: int
    true_colour: int
    linetype: str
    notes: tuple[str, ...]


_SILENT = _Layer(7, -1, "Continuous", ())
#: What BYBLOCK means outside of any block.
_SHEET = Style("0", 7, -1, "Continuous")


class Styles:
    """The layer table of one file."""

    def __init__(self, document: Document) -> None:
        self._layers: dict[str, _Layer] = {}
        for layer in document.layers:
            name = spelled(str(layer.dxf.get("name", ""))).lower()
            # A negative colour is the format's way to say that the layer is off; 0 says nothing.
            signed = int(layer.dxf.get("color", 7))
            notes = [
                text
                for text, holds in (
                    ("its layer is off", signed < 0),
                    ("its layer is frozen", bool(int(layer.dxf.get("flags", 0)) & 1)),
                    ("its layer is not plotted", layer.dxf.get("plot", 1) == 0),
                )
                if holds
            ]
            self._layers[name] = _Layer(
                _index(abs(signed)),
                _rgb(layer.dxf.get("true_color")),
                spelled(str(layer.dxf.get("linetype", "Continuous"))),
                tuple(notes),
            )

    def notes(self, layer: str) -> tuple[str, ...]:
        """Return what is to be said of everything on a layer: that it is off, frozen …"""
        return self._layers.get(layer.lower(), _SILENT).notes

    def of(self, entity: DXFGraphic, around: Style | None = None) -> Style:
        """Return the style of an entity.

        Parameters
        ----------
        entity
            Any graphical entity.
        around
            Style of the INSERT that it is placed by: what it takes for BYBLOCK, and for layer
            where it lies on layer 0.
        """
        dxf = entity.dxf
        name = spelled(str(dxf.get("layer", "0")))
        block = around or _SHEET
        if around is not None and name == "0":
            name = around.layer
        layer = self._layers.get(name.lower(), _SILENT)
        written = dxf.get("color", _BYLAYER)
        if written == _BYLAYER:
            colour, true_colour = layer.colour, layer.true_colour
        elif written == _BYBLOCK:
            colour, true_colour = block.colour, block.true_colour
        else:
            colour, true_colour = _index(written), -1
        if dxf.hasattr("true_color"):
            true_colour = _rgb(dxf.true_color)
        linetype = spelled(str(dxf.get("linetype", "BYLAYER")))
        if linetype.upper() == "BYLAYER":
            linetype = layer.linetype
        elif linetype.upper() == "BYBLOCK":
            linetype = block.linetype
        return Style(name, colour, true_colour, linetype)


def _index(colour: int) -> int:
    return colour if 1 <= colour <= 255 else 7


def _rgb(value: int | None) -> int:
    # The upper byte holds how the colour was chosen in some files.
    return -1 if value is None else int(value) & 0xFFFFFF
