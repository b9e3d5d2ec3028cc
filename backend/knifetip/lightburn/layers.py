"""layers: names, colours and line types of the layers of a LightBurn project.

A shape names its layer by the number of a colour (CutIndex).  The settings of a layer state its
name and what the laser does: it cuts along the line (Cut), or fills the shape with lines (Scan).

Source of the colours: LightBurn documentation 2.0, Reference, Color Palette.
"""

from __future__ import annotations

from typing import Final

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.visibility import LayerState, object_on_layer
from knifetip.messages import Message

#: Colours of the layers C00 to C29 and of the tool layers T1 and T2.
_COLOURS: Final = (
    *(0x000000, 0x0000FF, 0xFF0000, 0x00E000, 0xD0D000, 0xFF8000, 0x00E0E0, 0xFF00FF),
    *(0xB4B4B4, 0x0000A0, 0xA00000, 0x00A000, 0xA0A000, 0xC08000, 0x00A0FF, 0xA000A0),
    *(0x808080, 0x7D87B9, 0xBB7784, 0x4A6FE3, 0xD33F6A, 0x8CD78C, 0xF0B98D, 0xF6C4E1),
    *(0xFA9ED4, 0x500A78, 0xB45A00, 0x004754, 0x86FA88, 0xFFDB66, 0xF36926, 0x0C96D9),
)
#: Number of the first tool layer; LightBurn never outputs tool layers.
_FIRST_TOOL: Final = 30
#: Types of layers that are filled with lines or a picture, without an outline.
_FILLED: Final = frozenset(("Scan", "Offset", "Image"))
#: Linetype of a layer that is cut without gaps, and of one that is perforated.
_LINE: Final = "Continuous"
_PERFORATED: Final = "perforated"


class Layers:
    """The layers of a project.

    Parameters
    ----------
    settings
        The settings of each layer: ``index``, ``name``, ``type`` …
    """

    def __init__(self, settings: list[dict[str, str]]) -> None:
        self._settings = {one.get("index", ""): one for one in settings}

    def style(self, index: str) -> Style:
        """Return the style of the lines on a layer.

        ``index`` is the number of the layer, as the file contains it.
        """
        setting = self._settings.get(index, {})
        linetype = _PERFORATED if setting.get("perforate") == "1" else _LINE
        colour = _colour(index)
        return Style(self.name(index), nearest_index(colour), colour, linetype)

    def is_filled(self, index: str) -> bool:
        """Return whether the laser fills the shapes of a layer and does not follow their lines."""
        return self._settings.get(index, {}).get("type") in _FILLED

    def name(self, index: str) -> str:
        """Return the name of a layer; "C03" if the file states none."""
        name = self._settings.get(index, {}).get("name", "").strip()
        if name:
            return name
        number = _number(index)
        if number is None:
            return index[:40]
        return f"T{number - _FIRST_TOOL + 1}" if number >= _FIRST_TOOL else f"C{number:02}"

    def hidden(self, index: str) -> Message | None:
        """Return the reason for leaving out the shapes of a layer, None if the layer is used."""
        setting = self._settings.get(index, {})
        number = _number(index)
        is_tool = number is not None and number >= _FIRST_TOOL
        state = LayerState(
            off=setting.get("hide") == "1",
            plotted=not is_tool and setting.get("doOutput") != "0",
        )
        return object_on_layer(self.name(index), state)


def _number(index: str) -> int | None:
    """Return the number of a layer, None if it is no number of a colour of the palette."""
    if not index.isascii() or not index.isdecimal() or len(index) > 2:
        return None
    number = int(index)
    return number if number < len(_COLOURS) else None


def _colour(index: str) -> int:
    number = _number(index)
    return UNKNOWN_COLOUR if number is None else _COLOURS[number]
