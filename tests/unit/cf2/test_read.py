"""CF2: records, calls, units, types, bridges, damaged and hostile files."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip.cf2.read import read
from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.geometry.tolerance import CURVE
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from tests.support.drawings import report_reasons
from tests.support.reading import assert_lengths_add_up, read_or_refused
from tests.support.writers.cf2_text import arc, carton, cf2, line, sub


def reasons(drawing: Drawing) -> dict[str, str]:
    return dict(zip(drawing.import_report.handle, report_reasons(drawing), strict=True))


# ── Records ───────────────────────────────────────────────────────────────────────────────────


def test_a_line_has_ends_type_and_layer() -> None:
    drawing = read(cf2(line(1, 2, 11, 2), "L,3,3,8,0,0,0,5,0,0"))
    assert drawing.ends.tolist() == [[[1, 2], [11, 2]], [[0, 0], [0, 5]]]
    assert [drawing.linetypes[row] for row in drawing.linetype] == ["CF2 1 2pt", "CF2 3 aux 8 3pt"]
    assert drawing.layers == ("carton",)
    assert (drawing.unit, drawing.stated, drawing.evidence.code) == (
        "mm",
        "mm",
        "unit.cf2-millimetres",
    )


@pytest.mark.parametrize(("direction", "top"), [(1, 10.0), (-1, 0.0)])
def test_the_direction_of_an_arc_determines_its_side(direction: int, top: float) -> None:
    # From (10, 0) to (-10, 0) about the origin, above it if counter-clockwise.
    drawing = read(cf2(arc(10, 0, -10, 0, 0, 0, direction)))
    assert_allclose(drawing.bounds, [-10, top - 10, 10, top], atol=1e-9)
    assert_allclose(drawing.lengths.sum(), 10 * math.pi)


@pytest.mark.parametrize("direction", [1, -1])
def test_three_quarters_of_a_circle_are_two_rows(direction: int) -> None:
    drawing = read(cf2(arc(10, 0, 0, -10 * direction, 0, 0, direction)))
    assert len(drawing) == 2
    assert_allclose(drawing.lengths.sum(), 15 * math.pi)
    assert drawing.ends[0, 1].tolist() == drawing.ends[1, 0].tolist()
    assert_allclose(drawing.ends[0, 1], [-10 * math.sqrt(0.5), 10 * direction * math.sqrt(0.5)])


def test_an_arc_that_ends_where_it_starts_is_a_whole_circle() -> None:
    drawing = read(cf2(arc(15, 5, 15, 5, 10, 5)))
    assert_allclose(drawing.lengths.sum(), 10 * math.pi)
    assert_allclose(drawing.bounds, [5, 0, 15, 10], atol=1e-9)


def test_an_arc_with_a_wrong_centre_keeps_its_ends_and_is_noted() -> None:
    drawing = read(cf2(arc(10, 0, 0, 10.5, 0, 0)))
    assert drawing.ends.tolist() == [[[10, 0], [0, 10.5]]]
    assert (
        reasons(drawing)["#1"] == "the object was imported; note: the centre of the arc is 10 file "
        "units away from the start of the arc, but 10.5 file units away from the end of the arc"
    )


def test_bridges_are_notes_and_not_gaps() -> None:
    drawing = read(cf2(line(0, 0, 100, 0, bridges="3,6"), line(0, 1, 9, 1, bridges="1,4.5")))
    assert drawing.lengths.tolist() == [100.0, 9.0]
    assert report_reasons(drawing) == (
        "the object was imported; note: the steel rule of the cutting die "
        "has 3 bridges (gaps), each 6 file units wide; the edge is cut without the gaps",
        "the object was imported; note: the steel rule of the cutting die "
        "has 1 bridge (gap), 4.5 file units wide; the edge is cut without the gap",
    )


def test_variants_of_other_programs_are_read() -> None:
    text = (
        "\n\n$bof\nv2\norder\nmain idea: none\n\nend\nmain , x \num\nscale,1,1,\n\n"
        "l, 2, 1, 0, 0, 0, 10, 0\n  L,2,1,0,0,0,0,1e1,0,0,\nA,2,1,0,5,0,5,0,4,0,1\nend\n"
    )
    drawing = read(text.encode())
    assert len(drawing) == 4
    assert drawing.layers == ("x",)
    assert read(text.replace("\n", "\r").encode()).ends.tolist() == drawing.ends.tolist()
    assert read(text.encode("utf-16")).ends.tolist() == drawing.ends.tolist()


def test_records_without_a_header_are_read() -> None:
    drawing = read(b"L,2,1,0,0,0,10,0,0,0\nA,2,2,0,5,0,-5,0,0,0,1,0,0\n")
    assert len(drawing) == 2
    assert (drawing.unit, drawing.evidence.code) == ("", "unit.cf2-none")


def test_inches_are_converted() -> None:
    drawing = read(cf2(line(0, 0, 10, 0), head=("UI",)))
    assert (drawing.unit, drawing.stated) == ("in", "in")
    assert_allclose(drawing.lengths, [254.0])
    assert_allclose(read(cf2(line(0, 0, 10, 0), head=("UI",)), "mm").lengths, [10.0])


def test_texts_are_kept_as_annotations_and_never_cut() -> None:
    drawing = read(cf2("T,2,46,0,10,90,0,5,4", "L,2,1 is no line", line(0, 0, 1, 0)))
    (words,) = drawing.annotations
    assert (words.text, words.x, words.y, words.height) == ("L,2,1 is no line", 10, 90, 5)
    assert len(drawing) == 1
    assert drawing.import_report.outcome.tolist() == [ImportOutcome.DROPPED, ImportOutcome.KEPT]


# ── Calls ─────────────────────────────────────────────────────────────────────────────────────


def test_a_subroutine_is_scaled_then_rotated_then_moved() -> None:
    one = sub("A", line(0, 0, 10, 0))
    drawing = read(cf2("C,A,100,50,90,2,2", "C,a,0,0,0,-1,1", "C,A,5,5", subs=one))
    assert drawing.ends.tolist() == [[[100, 50], [100, 70]], [[0, 0], [-10, 0]], [[5, 5], [15, 5]]]
    assert drawing.import_report.handle == ("#1", "#1/#4", "#2", "#2/#4", "#3", "#3/#4")
    assert (
        reasons(drawing)["#2"]
        == "the object was imported; note: the object inserts the subroutine a"
    )
    assert set(drawing.layers) == {"A"}


def test_a_mirrored_arc_turns_the_other_way() -> None:
    drawing = read(cf2("C,A,0,0,0,-1,1", subs=sub("A", arc(10, 0, 0, 10, 0, 0))))
    assert_allclose(drawing.ends, [[[-10, 0], [0, 10]]], atol=1e-12)
    assert_allclose(drawing.bulge, [-math.tan(math.pi / 8)])


def test_an_unevenly_scaled_circle_is_an_ellipse() -> None:
    drawing = read(cf2("C,A,0,0,0,3,1", subs=sub("A", arc(10, 0, 10, 0, 0, 0), line(0, 0, 1, 0))))
    assert_allclose(drawing.bounds, [-30, -10, 30, 10], atol=0.011)
    assert drawing.ends[-1].tolist() == [[0, 0], [3, 0]]
    # The line is exact; the ellipse is approximated.
    assert drawing.fit_error[-1] == 0.0
    assert (drawing.fit_error[:-1] > 0.0).all()
    assert drawing.fit_error.max() <= CURVE


def test_calls_may_be_nested() -> None:
    subs = sub("A", "C,B,10,0,0,1,1", line(0, 0, 1, 0)) + "\r\n" + sub("B", line(0, 0, 2, 0))
    drawing = read(cf2("C,A,100,0,90,1,1", subs=subs))
    assert drawing.ends.tolist() == [[[100, 10], [100, 12]], [[100, 0], [100, 1]]]


def test_invalid_calls_are_reported() -> None:
    subs = "\r\n".join(
        [sub("A", "C,B,0,0,0,1,1"), sub("B", "C,A,0,0,0,1,1"), sub("IDLE", line(0, 0, 9, 0))]
    )
    drawing = read(cf2("C,A,0,0,0,1,1", "C,NONE,0,0,0,1,1", "C,A,nan,0,0,1,1", subs=subs))
    reason = reasons(drawing)
    assert reason["#1/#4/#5"] == "the subroutine A inserts itself"
    assert reason["#2"] == "the object inserts the subroutine NONE, which is not in the file"
    assert reason["#3"] == "the position of the object is not a number"
    assert (
        reason["IDLE"]
        == "the file defines the subroutine IDLE with 1 record, but the drawing does not use it"
    )


def test_without_calls_subroutines_keep_their_coordinates() -> None:
    drawing = read(b"$BOF\nSUB,A\nL,2,1,0,0,0,10,0,0,0\nEND\n$EOF\n")
    assert drawing.ends.tolist() == [[[0, 0], [10, 0]]]


# ── Scale ─────────────────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(("corner", "length"), [("UR,10,5", 10.0), ("UR,20,10", 20.0)])
def test_a_scale_is_applied_if_the_corners_require_it(corner: str, length: float) -> None:
    drawing = read(
        cf2(line(0, 0, 10, 0), line(0, 0, 0, 5), head=("UM", "LL,0,0", corner, "SCALE,2,2"))
    )
    assert drawing.lengths[0] == length
    assert drawing.unit == "mm"


def test_an_unexplained_scale_leaves_the_unit_open() -> None:
    drawing = read(cf2(line(0, 0, 10, 0), head=("UM", "SCALE,2,2")))
    assert (drawing.unit, drawing.lengths.tolist()) == ("", [10.0])
    assert drawing.evidence.arguments["scale"] == Message("unit.cf2-scale-undecided", x=2, y=2)


@pytest.mark.parametrize(
    ("head", "code"),
    [
        (("UM", "SCALE,2,2"), "unit.cf2-scale-undecided"),
        (("UM", "SCALE,0,2"), "unit.cf2-scale-invalid"),
    ],
)
def test_a_scale_that_is_ignored_for_no_known_reason_has_a_row_of_the_report(
    head: tuple[str, ...], code: str
) -> None:
    report = read(cf2(line(0, 0, 10, 0), head=head)).import_report
    assert report.kind[-1] == "SCALE"
    assert report.reason[-1].code == code
    assert report.outcome[-1] == ImportOutcome.DROPPED


def test_a_scale_that_the_corners_explain_has_no_row_of_the_report() -> None:
    head = ("UM", "LL,0,0", "UR,20,10", "SCALE,2,2")
    report = read(cf2(line(0, 0, 10, 0), line(0, 0, 0, 5), head=head)).import_report
    assert report.kind == ("L (line)", "L (line)")


def test_a_call_with_a_scale_of_0_is_dropped() -> None:
    drawing = read(cf2(line(0, 0, 1, 0), "C,A,0,0,0,0,1", subs=sub("A", line(0, 0, 5, 5))))
    report = drawing.import_report
    assert report.handle == ("#1", "#2")
    assert report.reason[1] == Message("import.no-scale", x=0, y=1)


def test_a_missing_end_mark_has_a_row_of_the_report() -> None:
    complete = cf2(line(0, 0, 10, 0))
    assert read(complete).import_report.kind == ("L (line)",)
    drawing = read(complete.replace(b"$EOF\r\n", b""))
    assert drawing.lengths.tolist() == [10.0]
    assert drawing.import_report.reason[-1] == Message("import.no-end-mark", mark="$EOF")


@pytest.mark.parametrize("centre", ["5,5", "9,5"])
def test_an_arc_around_one_of_its_ends_has_no_radius(centre: str) -> None:
    drawing = read(cf2(line(0, 0, 1, 0), f"A,2,1,0,5,5,9,5,{centre},1,0,0"))
    assert drawing.lengths.tolist() == [1.0]
    assert reasons(drawing)["#2"].startswith("the radius of the object is 0")


def test_an_empty_field_of_a_call_does_not_shift_the_others() -> None:
    drawing = read(cf2("C,A,,5,,,", subs=sub("A", line(0, 0, 1, 0))))
    assert drawing.ends.tolist() == [[[0, 5], [1, 5]]]


@pytest.mark.parametrize("record", ["SCALE,x,1", "SCALE,1", "UR,9O0,600"])
def test_a_header_record_without_numbers_has_a_row_of_the_report(record: str) -> None:
    drawing = read(cf2(line(0, 0, 1, 0), head=("UM", record)))
    assert drawing.lengths.tolist() == [1.0]
    assert reasons(drawing)["#1"].startswith("the values in line 8 of the file are not all numbers")


def test_an_underscore_in_a_number_is_not_ignored() -> None:
    drawing = read(cf2(line(0, 0, 1, 0), "L,2,1,0,0,0,1_0,0,0,0"))
    assert drawing.lengths.tolist() == [1.0]
    assert "1_0" in reasons(drawing)["#2"]


# ── Profiles ──────────────────────────────────────────────────────────────────────────────────

KINDS = (0, 1, 2, 3, 4, 6, 8, 9, 10, 12, 43, 46)


@pytest.mark.parametrize(
    ("profile", "known"),
    [
        ("default", {1: "cut", 2: "crease", 46: "ignored"}),
        ("cf2-plmpack", {1: "cut", 2: "crease", 3: "combi", 4: "half-cut", 43: "ignored"}),
        ("cf2-gpcs", {1: "cut", 3: "perforation", 4: "half-cut", 9: "ignored"}),
        ("cf2-aspose", {0: "ignored", 2: "crease", 3: "perforation", 4: "combi", 43: "ignored"}),
    ],
)
def test_profiles_contain_only_the_types_of_their_program(
    profile: str, known: dict[str, Any]
) -> None:
    drawing = read(cf2(*(line(0, k, 9, k, k) for k in KINDS)))
    line_type: dict[Any, str] = {**{1: "cut", 2: "crease", 46: "ignored"}, **known}
    rules = load.profile(profile).rules
    for kind, row in zip(KINDS, drawing.linetype, strict=True):
        name = drawing.linetypes[row]
        matching = [rule for rule in rules if any(_globs(glob, name) for glob in rule.linetype)]
        assert matching[0].line_type.word == line_type.get(kind, LineType.UNCLASSIFIED.word), kind


def _globs(pattern: str, name: str) -> bool:
    return name == pattern or (pattern.endswith("*") and name.startswith(pattern[:-1]))


# ── Whole files ───────────────────────────────────────────────────────────────────────────────


def test_lengths_in_the_report_add_up() -> None:
    drawing = read(carton())
    one = 200 + 60 + 10 * math.pi + 180 + 80 + 16 * math.pi + 3 * 80
    assert_allclose(drawing.lengths.sum(), 2 * one)
    assert_lengths_add_up(drawing)
    assert_allclose(drawing.bounds, [0, 0, 200, 180], atol=1e-9)


@pytest.mark.corpus
def test_a_layout_of_another_program_has_the_size_of_its_corners(corpus: Path) -> None:
    folder = corpus / "groupdocs-viewer__GroupDocs.Viewer-for-.NET"
    (file,) = folder.rglob("sample.cf2")
    drawing = read(file.read_bytes())
    assert_allclose(drawing.bounds, [10.492488, 34.045633, 294.307512, 423.154367], atol=2e-6)
    assert len(drawing) == 8 * 636 + 12
    assert drawing.linetypes == ("CF2 1 2pt",)


# ── Damaged and hostile ───────────────────────────────────────────────────────────────────────


def refused(data: bytes, kind: type[KnifetipError] = NotADrawing, **limits: int) -> str:
    start = time.process_time()
    with pytest.raises(kind) as caught:
        read(data, limits=Limits(**limits))
    assert time.process_time() - start < 10.0
    assert caught.value.hint
    return caught.value.text


def test_a_file_truncated_anywhere_is_refused_or_complete() -> None:
    whole = carton()
    drawing = read(whole)
    refusals = 0
    for length in range(len(whole)):
        try:
            part = read(whole[:length])
        except NotADrawing:
            refusals += 1
            continue
        # The end mark may be missing; a call of a missing subroutine is reported.
        lost = [reason for reason in report_reasons(part) if "which is not in the file" in reason]
        assert part.ends.tolist() == drawing.ends.tolist() or len(lost) == 2, whole[length - 30 :]
    assert refusals > 0.95 * len(whole)


def test_decimal_commas_are_refused_with_the_reason() -> None:
    rows = ["L,2,1,0,54,623664,10,09647,54,637004,10,16879,0,0"] * 9
    assert "seems to use decimal commas" in refused(cf2(*rows))


def test_single_damaged_records_are_dropped_with_a_reason() -> None:
    drawing = read(
        cf2(
            line(0, 0, 1, 0),
            "L,2,1,0,0,x,1,0,0,0",
            "L,2,1,0,0,0",
            "A,2,1,0,nan,0,0,1,0,0,1,0,0",
            line(0, 0, 1e308, 0),
            "Q,what,is,this",
            "A,2,1,0,5,5,5,5,5,5,1,0,0",
            "C",
        )
    )
    reason = reasons(drawing)
    assert reason["#2"] == "the coordinates of the object are not all numbers: 0, x, 1, 0"
    assert reason["#3"] == (
        "line 11 of the file has 6 fields, which is the wrong number of fields for its record"
    )
    assert reason["#4"].startswith("a coordinate of the object is not a number")
    assert (
        reason["#5"]
        == "a coordinate of the object is 1E308 file units, but the limit is 10,000,000"
    )
    assert reason["#6"] == "the object is a CF2 record of a type that is not supported"
    assert reason["#7"] == "the radius of the object is 0, but must be greater than 0"
    assert reason["#8"] == "the object inserts the subroutine , which is not in the file"
    assert drawing.lengths.tolist() == [1.0]


def test_expansion_bombs_and_deep_calls_are_refused() -> None:
    bomb = "\r\n".join(
        sub(f"S{k}", *[f"C,S{k + 1},0,0,0,1,1"] * 10) for k in range(12)
    ) + "\r\n" + sub("S12", line(0, 0, 1, 0))  # fmt: skip
    assert "expand to more than" in refused(cf2("C,S0,0,0,0,1,1", subs=bomb), DrawingTooLarge)
    tower = "\r\n".join(sub(f"S{k}", f"C,S{k + 1},0,0,0,1,1") for k in range(5000))
    assert "more than 16 levels deep" in refused(cf2("C,S0,0,0,0,1,1", subs=tower), DrawingTooLarge)
    nested = "SUB,A\r\n" * 20_000 + "END\r\n" * 20_000
    assert len(read(cf2(line(0, 0, 1, 0), subs=nested))) == 1


def test_limits_are_kept() -> None:
    many = cf2(*[line(0, k, 1, k) for k in range(50)])
    assert "more than 40 elements" in refused(many, DrawingTooLarge, entities=40)
    assert "more than 40 lines" in refused(many, DrawingTooLarge, segments=40)
    assert "0.0 MB" in refused(many, DrawingTooLarge, bytes=100)


@pytest.mark.parametrize("data", [b"", b"\n\n", b"$BOF\nV2\nORDER\nEND\n$EOF", b"$EOF", b"hello"])
def test_a_file_that_draws_nothing_is_refused(data: bytes) -> None:
    assert refused(data)


fields = st.one_of(
    st.sampled_from(["", "0", "1", "-1", "nan", "inf", "1e308", "1e-320", "x", "1,5", "É"]),
    st.floats(allow_nan=True).map(repr),
)


@given(
    st.lists(
        st.tuples(
            st.sampled_from(["L", "A", "C", "T", "END", "SUB", "MAIN", "SCALE", "UM", "a", ""]),
            st.lists(fields, max_size=13),
        ),
        max_size=8,
    )
)
def test_any_records_give_a_drawing_or_a_knifetip_error(
    records: list[tuple[str, list[str]]],
) -> None:
    lines = [",".join([word, *values]) for word, values in records]
    read_or_refused(read, cf2(*lines, subs=sub("1", line(0, 0, 1, 1))))


@given(st.binary(max_size=100), st.integers(0, 900), st.integers(0, 20))
def test_any_damage_gives_a_drawing_or_a_knifetip_error(noise: bytes, at: int, gone: int) -> None:
    whole = carton()
    read_or_refused(read, whole[:at] + noise + whole[at + gone :])
