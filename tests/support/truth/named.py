"""Drawings that must pass all stages from file to program, each with its board and profile."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing


@dataclass(frozen=True)
class Named:
    """A drawing of the corpus with its settings, or one of our samples if ``folder`` is ""."""

    folder: str
    file: str
    board: str
    unit: str | None = None
    profile: str = "default"

    def __str__(self) -> str:
        return self.file.removesuffix(".dxf")

    def data(self, corpus: Path | None) -> bytes:
        """Return the bytes of the file; ``corpus`` is the folder of the corpus."""
        if not self.folder:
            return samples()[self.file]
        assert corpus is not None
        return (corpus / self.folder / self.file).read_bytes()

    def classified(self, corpus: Path | None) -> tuple[Drawing, Dieline, Board]:
        """Return the drawing, its dieline without unclassified edges, and the board."""
        drawing = pipeline.read(self.data(corpus), self.unit)
        dieline = pipeline.classify(drawing, load.profile(self.profile))
        assert not (dieline.line_type == LineType.UNCLASSIFIED).any()
        assert len(dieline) == len(drawing) > 0
        assert np.isfinite(dieline.ends).all()
        return drawing, dieline, load.board(self.board)


_OBRARY = "Obrary__Parametric-Papercraft/Interchange-Files"
_RSC = "generated__bikinon__RSC-FEFCO-02xx"

SAMPLES = (
    Named("", "tuck-end-carton.dxf", "fbb-0.4"),
    Named("", "corrugated-tray.dxf", "b-flute"),
    Named("", "rigid-box-blank.dxf", "greyboard-2.0"),
)
NAMED = (
    Named(_OBRARY, "cube.dxf", "e-flute", "mm"),
    Named(_OBRARY, "long.dxf", "e-flute", "mm"),
    # Without flaps on one side, four of its creases lie on the outline.
    Named(_RSC, "f0200_B_300x200x150.dxf", "b-flute", "mm"),
    Named(_RSC, "f0201_B_400x300x250.dxf", "b-flute", "mm"),
    Named(_RSC, "f0203_B_350x250x100.dxf", "b-flute", "mm"),
    Named(
        "generated__eridur-de__mightyscape-inkpacking",
        "box_rwlf.dxf",
        "fbb-0.4",
        "mm",
        # A panel lacks its top edge, so three creases seem to bound the blank.
        "red-crease-black-cut",
    ),
)
