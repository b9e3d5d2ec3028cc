"""Record of an interpretation: a user's decisions about the drawing in a file."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.model.edit import Edits
from knifetip.model.job_options import JobOptions

#: In a column of overrides: the edge keeps the line type of its classification.
NO_OVERRIDE: Final = 255


@dataclass(frozen=True, slots=True)
class Interpretation:
    """The user's decisions about a drawing: unit, profile, overrides, edits, options of a job.

    An override is a line type that the user has set for one edge.  The record contains only plain
    data, so that it can be stored and sent to another process.
    """

    unit: str = ""  #: a key of ``model.unit.MILLIMETRES``; "" for the unit of the file
    profile: str = "default"  #: name of the classification profile
    rules: str = ""  #: TOML text of a customer's profile; "" for a profile of the library
    #: one byte per edge, ``NO_OVERRIDE`` or a LineType; b"" if no edge is overridden
    overrides: bytes = b""
    options: JobOptions = field(default_factory=JobOptions)  #: options of a job
    #: answers from earlier drawings of the customer, see ``customer_answers.learned_text``
    learned: str = ""
    edits: Edits = ()  #: changes of the geometry that the user has made

    @property
    def override_column(self) -> U8 | None:
        """Override of each edge, (n,): the LineType set by the user, or ``NO_OVERRIDE``.

        The value is None if the interpretation contains no overrides.
        """
        return np.frombuffer(self.overrides, np.uint8) if self.overrides else None
