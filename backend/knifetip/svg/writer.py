"""writer: the length of a pixel, from the name of the program that wrote an SVG.

CSS defines a pixel as 1/96 in, but older versions of Inkscape used 1/90 in, and Illustrator and
cutting plotters use 1/72 in.
"""

from __future__ import annotations

import re
from typing import Final

from knifetip.svg.document import Node

#: Number of bytes in which a program writes its name in a comment.
_HEAD: Final = 4096
#: Comments that name the program, and the unit in which it writes pixels.
_COMMENTS: Final = (
    (re.compile(rb"Adobe Illustrator"), "pt"),
    (re.compile(rb"<!--[^>]*\bCricut\b"), "pt"),
)
_VERSION: Final = re.compile(r"\s*(\d+)\.(\d+)")
#: The first version of Inkscape with pixels of 1/96 in.
_INKSCAPE_CSS: Final = (0, 92)


def pixel_unit(root: Node, data: bytes) -> str:
    """Return the unit of a pixel, a key of ``MILLIMETRES``, from the writer of the file.

    The result is "" if the writer is not known, or if the file names two writers with different
    pixels.

    Parameters
    ----------
    root
        Root element of the SVG, whose attributes name the version of Inkscape.
    data
        Content of the file, in whose first bytes programs write comments.
    """
    units = {unit for comment, unit in _COMMENTS if comment.search(data[:_HEAD])}
    if version := _VERSION.match(root.attributes.get("inkscape:version", "")):
        units.add("px" if (int(version[1]), int(version[2])) >= _INKSCAPE_CSS else "px-90")
    return units.pop() if len(units) == 1 else ""
