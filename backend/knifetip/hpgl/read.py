"""read: read a plotter file (HPGL or HP-GL/2).

``read`` returns a Drawing with segments in mm, and a row of the import report for every instruction
that draws.  Lines are distinguished by the pen, which is their layer, and by line type and width.

``instructions`` splits the file into instructions, ``trace`` executes them.
"""

from __future__ import annotations

from knifetip.drawing_builder.assemble import KnownUnit
from knifetip.formats.limits import Limits
from knifetip.formats.refusals import refuse_unexpected
from knifetip.hpgl.trace import trace
from knifetip.messages import Message
from knifetip.model.drawing import Drawing


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing in a plotter file.

    Parameters
    ----------
    data
        Content of the file.
    unit
        The unit that the user gives, "mm", "in" …; None if the user gives no unit.  The drawing is
        enlarged by the number of millimetres in this unit: with "in", a plotter unit is 1/40 in
        instead of 1/40 mm.  If the scale of the file depends on the plotter, a user unit of the
        file has the length ``unit``.
    limits
        Limits of the size of the file and of the drawing.

    Returns
    -------
    Drawing
        In mm.  If the scale depends on the plotter and the user gives no unit, the drawing is in
        user units of the file and its attribute ``unit`` is empty.

    Raises
    ------
    NotADrawing
        The file is no plotter file, contains no drawing, or is damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is not a unit.
    """
    with refuse_unexpected(data, unit, limits, "HPGL"):
        plot = trace(data, limits)
        stated = "mm" if plot.stated_scale else ""
        evidence = Message("unit.plotter" if stated else "unit.plotter-page")
        known = KnownUnit.choose(unit, stated, evidence)
        return plot.paths.drawing(plot.report, plot.annotations, known)
