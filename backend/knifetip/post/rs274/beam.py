"""beam: add lines to a program that switch a beam (laser, plasma) on only while it cuts.

Before the first move of a cut the beam is switched on and the head dwells until the board is
pierced; after the last move the beam is switched off.  M3 and M5 wait until the head is at rest.

grbl in laser mode ($32=1) keeps the beam off while G0 is active.  Therefore a G1 to the current
position precedes M3, so that the beam is on during the dwell.

Source: grbl 1.1 and grblHAL, documentation of laser mode.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry.columns import I32
from knifetip.model.tool import Tool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.rs274 import gcode


def switch_beam(
    text: bytes, source: I32, toolpath: Toolpath, tool: Tool, height: float, letter: str
) -> tuple[bytes, I32]:
    """Return program text with additional lines that switch the beam, and the toolpath row of each
    line of the new text.

    The added lines have row -1.

    Parameters
    ----------
    text
        Program lines of the moves of one station.
    source : (n,)
        Row of the toolpath for each of the n lines of ``text``, -1 for none.
    tool
        Laser or plasma torch, with its power and pierce time.
    height : mm
        Offset that the program adds to the tip's Z.
    letter
        Letter of the word that moves the head up and down.
    """
    cuts = (toolpath.motion[source] != Motion.RAPID) & (source >= 0)
    edges = np.diff(cuts.astype(np.int8), prepend=0, append=0)
    first, last = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    ends = np.concatenate([[0], np.flatnonzero(np.frombuffer(text, np.uint8) == ord("\n")) + 1])
    switch_on, switch_off = [f"M3 S{tool.spindle}"], ["M5"]
    if tool.pierce_time > 0.0:
        switch_on.append(gcode.dwell_line(tool.pierce_time))
    parts, at = [], 0
    for begin, end in zip(first.tolist(), last.tolist(), strict=True):
        row = int(source[begin])
        feed = gcode.format_number(float(toolpath.feed[row])).rstrip("0").rstrip(".")
        start = f"G1 {letter}{gcode.format_number(float(toolpath.pose[row, 2]) + height)} F{feed}"
        parts += [
            text[at : ends[begin]],
            _encode([start, *switch_on]),
            text[ends[begin] : ends[end]],
        ]
        parts.append(_encode(switch_off))
        at = int(ends[end])
    parts.append(text[at:])
    positions = np.concatenate(
        [np.repeat(first, 1 + len(switch_on)), np.repeat(last, len(switch_off))]
    )
    return b"".join(parts), np.insert(source, np.sort(positions, kind="stable"), np.int32(-1))


def _encode(lines: list[str]) -> bytes:
    """Return the program lines ``lines`` as ASCII bytes, with a newline after each line."""
    return "".join(f"{line}\n" for line in lines).encode("ascii")
