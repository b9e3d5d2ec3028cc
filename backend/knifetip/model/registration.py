"""Record of the registration of a printed sheet: its marks, and where they were measured."""

from __future__ import annotations

import math
from typing import Annotated, Final, Literal

import numpy as np
from pydantic import Field, model_validator

from knifetip.fields import LISTED, Table, field_error
from knifetip.geometry.similarity import Similarity, fit_similarity

#: Most marks of a sheet.
MOST_MARKS: Final = 20
#: Least distance of two marks in the drawing (mm): at less, the turn would be uncertain.
LEAST_DISTANCE: Final = 20.0
#: Greatest error of a mark (mm), unless an order states another one.
USUAL_LIMIT: Final = 0.5
#: Least and greatest scale of a print: paper and board do not change by more than that.
SCALES: Final = (0.98, 1.02)

_Coordinate = Annotated[float, Field(ge=-100_000.0, le=100_000.0)]
#: A point: X and Y (mm).
MarkPoint = Annotated[tuple[_Coordinate, _Coordinate], Field(strict=False)]


class Registration(Table):
    """Marks that are printed on a sheet, by which the job follows the print.

    The position of each mark is measured on the table.  The drawing is then shifted, turned and
    scaled so that its marks come to the measured ones.
    """

    marks: tuple[MarkPoint, ...] = Field(
        strict=False,  # JSON has lists
        min_length=2,
        max_length=MOST_MARKS,
        description="Centres of the marks in the drawing: X, Y (mm), in the order in which they "
        f"are measured. Two marks are at least {LEAST_DISTANCE:g} mm apart",
    )
    scale: Annotated[Literal["fit", "keep"], LISTED] = Field(
        default="fit",
        description="fit: the drawing is also scaled, for a print that is a little larger or "
        "smaller than drawn; tools keep their true sizes. keep: it keeps its size, and the "
        "difference is part of the errors of the marks",
    )
    limit: float = Field(
        default=USUAL_LIMIT,
        gt=0.0,
        le=5.0,
        description="Greatest permitted distance of a mark of the shifted, turned and scaled "
        "drawing from where it was measured (mm)",
    )
    measured: tuple[MarkPoint, ...] = Field(
        default=(),
        strict=False,  # JSON has lists
        max_length=MOST_MARKS,
        description="Where the marks lie on the table: X, Y (mm), in the same order; empty until "
        "they are measured. The sheet then lies at the origin of the machine. These are the "
        "positions in programs if the axes are square",
    )

    @model_validator(mode="after")
    def _plausible(self) -> Registration:
        if self.measured and len(self.measured) != len(self.marks):
            raise field_error(
                "field.measured-marks", marks=len(self.marks), measured=len(self.measured)
            )
        for number, mark in enumerate(self.marks):
            for other in self.marks[:number]:
                if math.dist(mark, other) < LEAST_DISTANCE:
                    raise field_error(
                        "field.close-marks",
                        x=mark[0],
                        y=mark[1],
                        distance=math.dist(mark, other),
                        least=LEAST_DISTANCE,
                    )
        return self

    @property
    def similarity(self) -> Similarity | None:
        """The map from the drawing to the table; None until the marks are measured.

        It is that of least squares, whatever the errors of the marks.
        """
        if not self.measured:
            return None
        drawn, measured = np.array(self.marks), np.array(self.measured)
        return fit_similarity(drawn, measured, keep_scale=self.scale == "keep")

    @property
    def note(self) -> str:
        """The registration as a comment for the head of a program."""
        similarity = self.similarity
        if similarity is None:
            return f"{len(self.marks)} marks not measured"
        return (
            f"marks: turn {similarity.turn:.4f} scale {similarity.scale:.6f} "
            f"shift X{similarity.x:.4f} Y{similarity.y:.4f}"
        )
