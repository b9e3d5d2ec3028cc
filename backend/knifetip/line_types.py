"""line_types: the stages that read a drawing and give its edges line types.

::

    bytes → Drawing → Dieline
        read    classify

``pipeline`` has them with the stages that follow.  The line types of a dieline come from the rules
of a profile, from earlier answers of the customer and from the user; ``questions`` returns what is
open.
"""

from __future__ import annotations

from knifetip.classification import classify as classification
from knifetip.classification.answers import follow_answers
from knifetip.classification.customer_answers import answer_from_drawings
from knifetip.classification.questions import list_questions
from knifetip.formats import open_file
from knifetip.geometry.columns import U8
from knifetip.library import custom_profiles, load
from knifetip.model.customer_answers import learned_from_text
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import Interpretation
from knifetip.model.machine import Machine
from knifetip.model.profile import LineRules
from knifetip.model.question import Question
from knifetip.planning.questions import tool_questions
from knifetip.units.evidence import find_unit
from knifetip.units.likeliest_unit import choose_unit
from knifetip.units.question import unit_question


def read(data: bytes, unit: str | None = None) -> Drawing:
    """Return the drawing in the bytes of a file of any import format.

    Parameters
    ----------
    data
        The file; its format is detected from its content.
    unit
        The unit of the drawing, a key of ``model.unit.MILLIMETRES``.  It replaces the unit that
        the file states.
        If it is None, the unit in the file is compared with the geometry.  It is replaced if
        another unit is far likelier.  If the evidence is not conclusive, ``Drawing.unit`` is empty.

    Raises
    ------
    ReadError
        The file is not a drawing, damaged, or too large.
    """
    # A file that another program must convert is converted once.
    file = open_file(data)
    drawing = file.read(unit or "")
    return drawing if unit else choose_unit(drawing, file.read)


def classify(drawing: Drawing, rules: LineRules, overrides: U8 | None = None) -> Dieline:
    """Return the edges of a drawing with their line types.

    Parameters
    ----------
    rules
        The classification profile.
    overrides : (n,)
        For each of the n edges the LineType that the user has set, or ``NO_OVERRIDE`` to keep the
        type from the classification.  None if the user has set no line type.  Open edges get the
        line types that follow from them.
    """
    dieline = classification.classify(drawing, rules, load.conventions())
    return _with_overrides(drawing, dieline, overrides)


def interpret(drawing: Drawing, interpretation: Interpretation) -> Dieline:
    """Return the edges of a drawing with the line types that a profile and the user give them.

    ``interpretation`` contains the name or content of the classification profile, what earlier
    drawings of the customer taught, and the line types that the user has set for single edges.
    """
    return apply_answers(drawing, classify(drawing, rules_of(interpretation)), interpretation)


def apply_answers(drawing: Drawing, dieline: Dieline, interpretation: Interpretation) -> Dieline:
    """Return a classified dieline with the answers of earlier drawings and those of the user.

    ``dieline`` contains the edges of ``drawing`` as ``classify`` returns them without overrides.
    """
    learned = learned_from_text(interpretation.learned)
    known = answer_from_drawings(drawing, dieline, learned)
    return _with_overrides(drawing, known, interpretation.override_column)


def _with_overrides(drawing: Drawing, dieline: Dieline, overrides: U8 | None) -> Dieline:
    """Return a dieline with the line types that the user gives, (n,), and what follows from them.

    ``overrides`` is None if the user has set no line type.
    """
    if overrides is None:
        return dieline
    answered = classification.apply_overrides(dieline, overrides)
    return follow_answers(drawing, dieline, answered, overrides)


def rules_of(interpretation: Interpretation) -> LineRules:
    """Return the rules of the classification profile that a user has chosen for a drawing.

    ``interpretation`` contains the TOML text of a customer's profile, or the name of a profile of
    the library.
    """
    if interpretation.rules:
        return custom_profiles.parse_text(interpretation.profile, interpretation.rules)
    return load.profile(interpretation.profile, files=False)


def questions(drawing: Drawing, dieline: Dieline, machine: Machine | None = None) -> list[Question]:
    """Return the questions about a drawing that the user must still answer.

    If a machine is given, these include questions about line types for which it has no tool.
    """
    unit = None if drawing.unit else unit_question(drawing, find_unit(drawing))
    open_questions = ([unit] if unit else []) + list_questions(drawing, dieline)
    return open_questions if machine is None else open_questions + tool_questions(dieline, machine)
