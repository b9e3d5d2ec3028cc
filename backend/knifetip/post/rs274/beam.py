"""beam: a tool that is switched on only while it cuts.

    lines of a station's moves -> the same with the beam on for every cut, and off for every rapid

Before the first move of a cut the beam is switched on and stays in place until it has pierced the
board; after its last move it is switched off.  M3 and M5 wait until the head is at rest.

grbl in laser mode ($32=1) keeps a beam off while G0 is in force.  So a G1 to where the head already
is comes before M3, and the beam is on while it pierces.

Source: grbl 1.1 and grblHAL, documentation of laser mode.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import I32
from knifetip.model.tool import Tool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.rs274 import gcode


def switched_beam(
    text: bytes, source: I32, toolpath: Toolpath, tool: Tool, height: float
) -> tuple[bytes, I32]:
    """Return the text with the beam switched, and the row of each of its lines.

    Parameters
    ----------
    source : (n,)
        Row of the toolpath of each line, -1 for none.
    height : mm
        Added to the tip's Z in the numbers of the program.
    """
    cuts = (toolpath.motion[source] != Motion.RAPID) & (source >= 0)
    edges = np.diff(cuts.astype(np.int8), prepend=0, append=0)
    first, last = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    ends = np.concatenate([[0], np.flatnonzero(np.frombuffer(text, np.uint8) == ord("\n")) + 1])
    on, off = [f"M3 S{tool.spindle}"], ["M5"]
    if tool.pierce_time > 0.0:
        on.append(gcode.dwell(tool.pierce_time))
    parts, at = [], 0
    for begin, end in zip(first.tolist(), last.tolist(), strict=True):
        row = int(source[begin])
        feed = gcode.plain(float(toolpath.feed[row])).rstrip("0").rstrip(".")
        here = f"G1 Z{gcode.plain(float(toolpath.pose[row, 2]) + height)} F{feed}"
        parts += [text[at : ends[begin]], _text([here, *on]), text[ends[begin] : ends[end]]]
        parts.append(_text(off))
        at = int(ends[end])
    parts.append(text[at:])
    places = np.concatenate([np.repeat(first, 1 + len(on)), np.repeat(last, len(off))])
    return b"".join(parts), np.insert(source, np.sort(places, kind="stable"), np.int32(-1))


def _text(lines: list[str]) -> bytes:
    return "".join(f"{line}\n" for line in lines).encode("ascii")
