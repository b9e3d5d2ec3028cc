"""samples: writes the sample drawings of the page and their pictures.

knifetip.dxf.samples -> public/samples/*.dxf, *.svg          samples.py

The page offers them while it has no drawings; each is opened as a file that a user has dropped.
"""

from __future__ import annotations

from pathlib import Path

from knifetip.dxf.samples import samples
from knifetip.model.interpretation import Interpretation
from knifetip.presentation.picture import svg_picture
from knifetip.service.processes import tasks

FOLDER = Path(__file__).resolve().parent / "public" / "samples"


def files() -> dict[str, bytes]:
    """Return the contents of the samples and of their pictures, by file name."""
    found: dict[str, bytes] = {}
    for name, content in samples().items():
        found[name] = content
        found[name.removesuffix(".dxf") + ".svg"] = _picture(content)
    return found


def _picture(content: bytes) -> bytes:
    """Return a picture of a drawing, in the colours of its line types."""
    reading = tasks.read(lambda *_: None, content, Interpretation())
    return svg_picture(reading.edges).encode()


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, content in files().items():
        (FOLDER / name).write_bytes(content)
