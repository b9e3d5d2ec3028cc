"""visibility: which objects are left out of a drawing because their author does not see them.

An object is left out if it is marked as invisible, or if its layer is not displayed or not plotted.
The import report contains the reason, and the drawing has a warning.

The rules for the objects of blocks are those of AutoCAD:

* An object of a block on layer 0 lies on the layer of the INSERT that places the block.
* A frozen layer hides the INSERTs on it, with all objects that they place.
* A layer that is off, or that is not plotted, hides only the objects that lie on it.  An INSERT on
  this layer still shows the objects of its block that lie on other layers.

A layer that is frozen only in a viewport of a layout hides nothing.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from knifetip.messages import Message

#: Reason for an object that is itself marked as invisible.
INVISIBLE: Final = Message("import.invisible")

_FROZEN: Final = Message("import.layer-frozen")
_OFF: Final = Message("import.layer-off")
_NOT_PLOTTED: Final = Message("import.layer-not-plotted")
_NEVER_PLOTTED: Final = Message("import.layer-never-plotted")
#: Layer for the definition points of dimensions; CAD programs never plot it.
_DEFINITION_POINTS: Final = "defpoints"


class LayerState(NamedTuple):
    """Whether the objects on a layer are displayed and plotted."""

    off: bool = False
    frozen: bool = False
    plotted: bool = True


def object_on_layer(name: str, state: LayerState) -> Message | None:
    """Return the reason for leaving out an object that lies on a layer; None if it is visible.

    ``name`` and ``state`` are the name and the state of the layer.
    """
    if state.frozen:
        return _FROZEN
    if state.off:
        return _OFF
    if name.lower() == _DEFINITION_POINTS:
        return _NEVER_PLOTTED
    return None if state.plotted else _NOT_PLOTTED


def insert_on_layer(state: LayerState) -> Message | None:
    """Return the reason for leaving out an INSERT with all objects that it places.

    None if the state of the layer does not hide the INSERT; the layers of the placed objects may
    still hide them.
    """
    return _FROZEN if state.frozen else None
