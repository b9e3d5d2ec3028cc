"""What the drawings of one customer teach, and where it must not decide."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.classification.answers import follow_answers
from knifetip.classification.classify import apply_overrides
from knifetip.classification.customer_agreement import learn_answers
from knifetip.classification.customer_answers import (
    answer_from_drawings,
    collect_uses,
    learned_edges,
)
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.customer_answers import (
    LearnedAnswer,
    Look,
    LookUse,
    TaughtDrawing,
    learned_from_text,
    learned_text,
)
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from tests.support.cartons.companies import COMPANIES
from tests.support.cartons.company_files import company_file, truth
from tests.support.writers import dxf_text as text

LOOK = Look("q7", 5, -1, "continuous", -1)
CREASE, CUT, IGNORED = LineType.CREASE, LineType.CUT, LineType.IGNORED


def taught(name: str, *uses: tuple[str, LineType], look: Look = LOOK) -> TaughtDrawing:
    return TaughtDrawing(
        name, f"hash of {name}", tuple(LookUse(look, reason, kind, 2) for reason, kind in uses)
    )


def free_lines(side: float, *styles: tuple[str, int]) -> Drawing:
    """Return a cut square with a line inside it for each pair of layer and colour."""
    corners = ((0.0, 0.0), (side, 0.0), (side, side), (0.0, side), (0.0, 0.0))
    lines = [text.line(*a, *b, (8, "CUT")) for a, b in pairwise(corners)]
    lines += [
        text.line(20.0, 20.0 + 10 * at, 60.0, 20.0 + 10 * at, (8, layer), (62, colour))
        for at, (layer, colour) in enumerate(styles)
    ]
    return pipeline.read(text.dxf(*lines, units=4))


def classified(drawing: Drawing) -> Dieline:
    return pipeline.classify(drawing, load.profile("default"))


def answered(drawing: Drawing, **types: LineType) -> tuple[LookUse, ...]:
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    for row, layer in enumerate(drawing.layer.tolist()):
        overrides[row] = types.get(drawing.layers[layer], NO_OVERRIDE)
    return collect_uses(drawing, classified(drawing), overrides)


def test_two_drawings_that_agree_suffice() -> None:
    one = taught("a.dxf", ("free", CREASE))
    (alone,) = learn_answers([one], "new")
    assert (alone.line_type, alone.sure, alone.drawings) == (CREASE, False, ("a.dxf",))
    (both,) = learn_answers([taught("b.dxf", ("free", CREASE)), one], "new")
    assert (both.sure, both.drawings) == (True, ("b.dxf", "a.dxf"))


def test_the_same_file_needs_no_second_drawing_and_is_none() -> None:
    one = taught("a.dxf", ("free", CREASE))
    assert learn_answers([one], one.sha256)[0].sure
    again = TaughtDrawing("copy.dxf", one.sha256, one.uses)
    assert not learn_answers([again, one], "new")[0].sure


@pytest.mark.parametrize("reason", ["free", ""])
def test_nothing_is_learned_from_drawings_that_disagree(reason: str) -> None:
    drawings = [taught("a.dxf", ("free", CREASE)), taught("b.dxf", (reason, CUT))]
    assert [one for one in learn_answers(drawings, "new") if one.reason == ""] == []


def test_edges_that_were_decided_without_an_answer_teach_but_leave_nothing_out() -> None:
    decided = [taught("a.dxf", ("", CREASE)), taught("b.dxf", ("", CREASE))]
    assert learn_answers(decided, "new")[0].sure
    assert learn_answers(decided[:1], "new") == ()
    assert learn_answers([*decided[:1], taught("c.dxf", ("free", CREASE))], "new")[0].sure
    left_out = [taught("a.dxf", ("", IGNORED)), taught("b.dxf", ("", IGNORED))]
    assert not any(one.sure for one in learn_answers(left_out, "new"))


def test_of_an_ambiguous_look_only_left_out_edges_are_learned_by_reason() -> None:
    drawings = [
        taught(name, ("", CUT), ("dimension", IGNORED), ("divider", CREASE))
        for name in ("a.dxf", "b.dxf")
    ]
    assert [(one.reason, one.line_type) for one in learn_answers(drawings, "new")] == [
        ("dimension", IGNORED)
    ]


def test_a_look_that_was_taken_back_is_not_learned() -> None:
    drawings = [taught("a.dxf", ("free", CREASE)), taught("b.dxf", ("free", CREASE))]
    assert learn_answers(drawings, "new", {LOOK}) == ()
    assert learn_answers(drawings, "new", {Look("q8", 5, -1, "continuous", -1)}) != ()


def test_answers_survive_their_text() -> None:
    learned = learn_answers([taught("a.dxf", ("free", CREASE))], "new")
    assert learned_from_text(learned_text(learned)) == learned
    assert learned_text(()) == ""


def test_the_third_drawing_of_a_customer_asks_nothing() -> None:
    uses = [
        answered(free_lines(side, ("Q7", 5), ("Q7", 5)), Q7=LineType.PERFORATION)
        for side in (100.0, 110.0)
    ]
    drawings = [TaughtDrawing(f"{at}.dxf", str(at), one) for at, one in enumerate(uses)]
    third = free_lines(120.0, ("Q7", 5), ("Q8", 5))
    learned = learn_answers(drawings, "new")
    dieline = answer_from_drawings(third, classified(third), learned)
    assert dieline.line_type[-2:].tolist() == [LineType.PERFORATION, LineType.UNCLASSIFIED]
    reason = dieline.rules[dieline.rule[-2]]
    assert reason.code == "classification.learned"
    assert reason.arguments["drawings"] == ("0.dxf", "1.dxf")
    ((answer, rows),) = learned_edges(third, dieline, learned).items()
    assert (answer.look.layer, rows.tolist()) == ("q7", [len(third) - 2])


def test_one_drawing_only_suggests() -> None:
    one = answered(free_lines(100.0, ("Q7", 5)), Q7=LineType.PERFORATION)
    second = free_lines(110.0, ("Q7", 5))
    learned = learn_answers([TaughtDrawing("a.dxf", "a", one)], "new")
    dieline = answer_from_drawings(second, classified(second), learned)
    assert dieline.line_type[-1] == LineType.UNCLASSIFIED
    (question,) = pipeline.questions(second, dieline)
    assert question.choices[0] == "perforation"
    assert "a.dxf" in question.text


def test_a_decided_edge_keeps_its_line_type() -> None:
    drawing = free_lines(100.0, ("Q7", 5))
    look = Look("cut", int(drawing.colour[0]), int(drawing.true_colour[0]), "continuous", -1)
    wrong = LearnedAnswer(look, "", CREASE, ("a.dxf",), True)
    decided = classified(drawing)
    dieline = answer_from_drawings(drawing, decided, [wrong])
    assert (dieline.line_type == decided.line_type).all()


def test_a_shape_that_clearly_means_another_line_type_is_asked_about() -> None:
    drawing = free_lines(100.0, ("Q7", 5))
    decided = classified(drawing)
    number = int(decided.rule[-1])
    clear = replace(
        decided,
        confidence=np.where(decided.line_type == 0, 0.8, decided.confidence),
        alternatives=tuple(
            (CUT,) if at == number else one for at, one in enumerate(decided.alternatives)
        ),
    )
    sure = LearnedAnswer(LOOK, "", CREASE, ("a.dxf", "b.dxf"), True)
    assert answer_from_drawings(drawing, clear, [sure]).line_type[-1] == LineType.UNCLASSIFIED
    assert answer_from_drawings(drawing, decided, [sure]).line_type[-1] == CREASE


def test_an_answer_does_not_reach_open_edges_whose_shape_suggests_another_line_type() -> None:
    drawing = free_lines(100.0, ("Q7", 5), ("Q7", 5))
    decided = classified(drawing)
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    overrides[-2] = CREASE
    rule = decided.rule.copy()
    rule[-1] = len(decided.rules)

    def followed(answered_guess: LineType, open_guess: LineType) -> int:
        guesses = list(decided.alternatives)
        guesses[decided.rule[-2]] = (answered_guess,)
        before = replace(
            decided,
            rule=rule,
            rules=(*decided.rules, Message("classification.as-its-style")),
            alternatives=(*guesses, (open_guess,)),
        )
        after = apply_overrides(before, overrides)
        return int(follow_answers(drawing, before, after, overrides).line_type[-1])

    assert followed(CREASE, CREASE) == CREASE
    assert followed(CREASE, IGNORED) == LineType.UNCLASSIFIED
    assert followed(CUT, IGNORED) == LineType.UNCLASSIFIED
    # The user has refused the same suggestion for the other edge.
    assert followed(IGNORED, IGNORED) == CREASE


def test_layers_without_a_meaning_are_one_look() -> None:
    uses = answered(free_lines(100.0, ("Ebene 3", 5)), **{"Ebene 3": CREASE})
    other = free_lines(100.0, ("Layer 9", 5))
    learned = learn_answers([TaughtDrawing(n, n, uses) for n in ("a", "b")], "new")
    dieline = answer_from_drawings(other, classified(other), learned)
    assert dieline.line_type[-1] == CREASE


def test_the_user_has_the_last_word() -> None:
    uses = answered(free_lines(100.0, ("Q7", 5)), Q7=CREASE)
    learned = learned_text(learn_answers([TaughtDrawing(n, n, uses) for n in ("a", "b")], "new"))
    drawing = free_lines(100.0, ("Q7", 5))
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    known = pipeline.interpret(drawing, Interpretation(learned=learned))
    assert known.line_type[-1] == CREASE
    overrides[-1] = IGNORED
    given = Interpretation(learned=learned, overrides=overrides.tobytes())
    assert pipeline.interpret(drawing, given).line_type[-1] == IGNORED


def test_streams_of_cartons_ask_less_and_learn_nothing_wrong() -> None:
    """Each company sends four cartons; the answers are the line types that it meant."""
    asked = np.zeros((2, 4), int)
    for number, company in enumerate(COMPANIES[::6]):
        taught_so_far: list[TaughtDrawing] = []
        for at in range(4):
            data, strokes, _ = company_file(company, 5 * at + 17 * number)
            drawing = pipeline.read(data)
            meant, _ = truth(drawing, strokes)
            plain = classified(drawing)
            learned = learn_answers(taught_so_far, str(at))
            dieline = answer_from_drawings(drawing, plain, learned)
            from_earlier = (plain.line_type == 0) & (dieline.line_type != 0)
            wrong = from_earlier & (dieline.line_type != meant)
            assert not wrong.any(), (company.name, at)
            for row, line in enumerate((plain, dieline)):
                asked[row, at] += len(pipeline.questions(drawing, line))
            still_open = dieline.line_type == LineType.UNCLASSIFIED
            overrides = np.where(still_open, meant, NO_OVERRIDE).astype(np.uint8)
            uses = collect_uses(drawing, plain, overrides)
            taught_so_far.insert(0, TaughtDrawing(f"{at}.dxf", str(at), uses))
    assert asked[1, 2:].sum() < asked[0, 2:].sum()
