"""HPGL: instructions, scales, pens, polygons, encoded polylines, damaged and hostile files."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.geometry.tolerance import CURVE
from knifetip.hpgl.read import read
from knifetip.model.drawing import NO_LINE_WIDTH, Drawing, ImportOutcome
from tests.support.drawings import report_reasons
from tests.support.reading import assert_lengths_add_up, read_or_refused
from tests.support.writers.hpgl_text import encoded

#: A line of one millimetre along X; a test of states draws it last.
LINE = "PA;PU0,0;PD40,0;"


def plot(text: str) -> Drawing:
    """Return the drawing of a plotter file that begins with IN and pen 1."""
    return read(f"IN;SP1;{text}".encode("latin-1"))


def reasons(drawing: Drawing) -> dict[str, str]:
    return dict(zip(drawing.import_report.kind, report_reasons(drawing), strict=True))


def styles(drawing: Drawing) -> list[tuple[str, str, int]]:
    """Return layer, linetype and line width of each edge."""
    return [
        (drawing.layers[layer], drawing.linetypes[linetype], width)
        for layer, linetype, width in zip(
            drawing.layer.tolist(),
            drawing.linetype.tolist(),
            drawing.line_width.tolist(),
            strict=True,
        )
    ]


# ── Moves ─────────────────────────────────────────────────────────────────────────────────────


def test_coordinates_are_fortieths_of_a_millimetre() -> None:
    drawing = plot("PU0,0;PD8000,0,8000,5600;PU;SP0;")
    assert drawing.ends.tolist() == [[[0, 0], [200, 0]], [[200, 0], [200, 140]]]
    assert (drawing.unit, drawing.stated, drawing.evidence.code) == ("mm", "mm", "unit.plotter")
    assert drawing.layers == ("pen 1",)
    assert list(drawing.import_report.kind) == ["PD (pen down)"]
    assert list(drawing.import_report.handle) == ["#4"]


@pytest.mark.parametrize(
    "text",
    [
        "PU40,80;PD120,80;PU;",
        "PU;PA40,80;PD;PA120,80;PU;",
        "PU40,80;PR;PD80,0;PU;",
        "PU0,0;PR;PU40,80;PD40,0,40,0;PA;PU;",
        "pu40 80 pd120 80\n",
        "PU40,80PD120,80PU",
        "PU +40.0 , 80.\r\n PD120,+80;",
        "PU40+80;PD120+80;",
        "PA;PU40,80;PD\n120,80\n;;;",
        "PA,PU40,80,PD120,80,PU",
        "\x1b.I81;;17:\x1b.N;19:PU40,80;\x1b.(PD120,80;\x1b.)",
        'CO"PD1,1;";PU40,80;PD120,80;MG"PD";',
        "NP8;VS20;FS3,1;PU40,80;PD120,80;",
    ],
)
def test_a_line_can_be_written_in_many_ways(text: str) -> None:
    drawing = plot(text)
    assert [drawing.ends[0, 0].tolist(), drawing.ends[-1, 1].tolist()] == [[1, 2], [3, 2]]
    assert_allclose(drawing.lengths.sum(), 2)
    assert set(report_reasons(drawing)) == {"the object was imported unchanged"}


@pytest.mark.parametrize(
    "file",
    [
        b"\x1b%-1BBP;IN;SP1;PU40,80;PD120,80;PG;\x1b%-1A",
        b"\x1bE\x1b&l0O\x1b*t300R\x1b%0BIN;SP1;PU40,80;PD\x1b%1Abitmap of the logo\x1b%1BPA120,80;",
        b"\x1b%-12345X@PJL COMMENT plot\r\n@PJL ENTER LANGUAGE=HPGL2\r\nIN;SP1;PU40,80;PD120,80;"
        b"\x1b%-12345X@PJL EOJ\r\n",
        b"\x1b.(;:IN;SP1;PU40,80;PD120,80;",
    ],
)
def test_commands_of_printers_and_interfaces_are_skipped(file: bytes) -> None:
    assert read(file).ends.tolist() == [[[1, 2], [3, 2]]]


def test_initialising_lifts_the_pen_and_ends_relative_mode() -> None:
    drawing = plot("PU0,0;PR;PD40,0;IN;SP1;PA40,40;PD80,40;")
    assert drawing.ends.tolist() == [[[0, 0], [1, 0]], [[1, 1], [2, 1]]]


# ── Arcs and curves ───────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(("degrees", "end"), [(90, (0, 10)), (-90, (0, -10)), (270, (0, -10))])
def test_an_arc_turns_about_its_centre(degrees: int, end: tuple[float, float]) -> None:
    drawing = plot(f"PU400,0;PD;AA0,0,{degrees};")
    assert_allclose(drawing.ends[-1, 1], end, atol=1e-9)
    assert_allclose(drawing.lengths.sum(), 10 * math.radians(abs(degrees)))
    assert len(drawing) == (2 if degrees == 270 else 1)


def test_a_relative_arc_is_continued_by_a_line() -> None:
    drawing = plot("PU400,0;PD;AR-400,0,180,5;PR0,-40;")
    assert_allclose(drawing.bounds, [-10, -1, 10, 10], atol=1e-9)
    assert_allclose(drawing.ends[-1], [[-10, 0], [-10, -1]], atol=1e-9)


@pytest.mark.parametrize("name", ["AT", "RT"])
def test_an_arc_through_three_points_has_exact_ends(name: str) -> None:
    base = (0, 0) if name == "AT" else (400, 0)
    numbers = (0 - base[0], 400 - base[1], -400 - base[0], 0 - base[1])
    drawing = plot(f"PU400,0;PD;{name}{','.join(map(str, numbers))};")
    assert_allclose(drawing.bounds, [-10, 0, 10, 10], atol=1e-9)
    assert drawing.ends[-1, 1].tolist() == [-10, 0]
    assert_allclose(drawing.lengths.sum(), 10 * math.pi)


def test_an_arc_through_a_point_to_the_right_is_clockwise() -> None:
    drawing = plot("PU400,0;PD;AT0,-400,0,400;")
    assert_allclose(drawing.bounds, [-10, -10, 10, 10], atol=1e-9)
    assert_allclose(drawing.lengths.sum(), 15 * math.pi)
    assert (drawing.bulge < 0.0).all()


def test_equal_ends_of_an_arc_through_a_point_are_a_circle() -> None:
    drawing = plot("PU400,0;PD;AT-400,0,400,0;PR0,40;")
    assert_allclose(drawing.lengths.sum(), 20 * math.pi + 1)
    assert drawing.ends[-1].tolist() == [[10, 0], [10, 1]]


def test_three_points_on_a_line_are_a_line() -> None:
    assert_allclose(plot("PU0,0;PD;AT40,40,80,80;").lengths.sum(), 2 * math.sqrt(2))


def test_a_circle_is_drawn_with_the_pen_up_and_leaves_the_pen_at_its_centre() -> None:
    drawing = plot("PU400,400;CI200;PR;PD40,0;")
    assert_allclose(drawing.lengths.sum(), 10 * math.pi + 1)
    assert_allclose(drawing.bounds, [5, 5, 15, 15], atol=1e-9)
    assert drawing.ends[-1].tolist() == [[10, 10], [11, 10]]


@pytest.mark.parametrize(
    ("text", "bounds", "length"),
    [
        ("PU40,80;EA120,200;", [1, 2, 3, 5], 10),
        ("PU40,80;ER80,120;", [1, 2, 3, 5], 10),
        ("PU40,80;EW400,0,90;", [1, 2, 11, 12], 20 + 5 * math.pi),
        ("PU40,80;EW-400,0,90;", [-9, -8, 1, 2], 20 + 5 * math.pi),
        ("PU40,80;EW400,0,360;", [-9, -8, 11, 12], 20 * math.pi),
    ],
)
def test_outlines_are_drawn_with_the_pen_up(text: str, bounds: list[float], length: float) -> None:
    drawing = plot(text)
    assert_allclose(drawing.bounds, bounds, atol=1e-9)
    assert_allclose(drawing.lengths.sum(), length)


@pytest.mark.parametrize("name", ["BZ", "BR"])
def test_a_bezier_curve_is_fitted(name: str) -> None:
    x = 0 if name == "BZ" else 4000
    k = round(4000 * 4 / 3 * (math.sqrt(2) - 1))
    points = [4000 - x, k, k - x, 4000, -x, 4000]
    drawing = plot(f"PU4000,0;PD;{name}{','.join(map(str, points))};")
    assert_allclose(drawing.ends[-1, 1], [0, 100], atol=1e-9)
    assert_allclose(drawing.lengths.sum(), 50 * math.pi, atol=0.05)
    assert 0.0 < drawing.fit_error.max() <= CURVE


# ── Scales, rotation, window ──────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("scale", "expected"),
    [
        ("IP0,0,4000,4000;SC0,100,0,100;", [[1, 2], [3, 2]]),
        ("IP400,0,4400,8000;SC0,100,0,100;", [[11, 4], [13, 4]]),
        ("IP0,0,4000,8000;SC0,100,0,100,1;", [[1, 52], [3, 52]]),
        ("IP0,0,4000,8000;SC0,100,0,100,1,0,0;", [[1, 2], [3, 2]]),
        ("SC0,40,0,40,2;", [[1, 2], [3, 2]]),
        ("IP0,0,4000,4000;SC100,0,0,100;", [[99, 2], [97, 2]]),
        ("IP0,0,1,1;IP0,0,4000,4000;SC0,100,0,100;RO90;", [[-2, 1], [-2, 3]]),
        ("RO180;SC0,40,0,40,2;", [[-1, -2], [-3, -2]]),
    ],
)
def test_user_units_have_the_size_that_the_file_states(
    scale: str, expected: list[list[float]]
) -> None:
    drawing = plot(f"{scale}PU1,2;PD3,2;")
    assert_allclose(drawing.ends[0], expected, atol=1e-9)
    assert drawing.unit == "mm"


def test_an_arc_in_uneven_user_units_is_an_ellipse() -> None:
    drawing = plot("IP0,0,4000,8000;SC0,100,0,100;PU50,50;CI10;")
    assert_allclose(drawing.bounds, [40, 80, 60, 120], atol=0.01)
    assert 0.0 < drawing.fit_error.max() <= CURVE


def test_the_pen_keeps_its_place_when_the_scale_changes() -> None:
    drawing = plot("PU400,400;SC0,40,0,40,2;PR;PD1,0;SC;PD40,0;")
    assert_allclose(drawing.ends, [[[10, 10], [11, 10]], [[11, 10], [12, 10]]], atol=1e-12)


def test_a_scale_that_depends_on_the_paper_leaves_the_unit_open() -> None:
    drawing = plot("SC0,100,0,100;PU1,2;PD3,2;")
    assert drawing.ends.tolist() == [[[1, 2], [3, 2]]]
    assert (drawing.unit, drawing.evidence.code) == ("", "unit.plotter-page")
    given = read(b"IN;SP1;SC0,100,0,100;PU1,2;PD3,2;", "in")
    assert_allclose(given.ends, [[[25.4, 50.8], [76.2, 50.8]]])


def test_a_second_scale_beside_one_that_depends_on_the_paper_is_refused() -> None:
    with pytest.raises(NotADrawing) as caught:
        plot(f"SC0,100,0,100;PU1,2;PD3,2;SC;{LINE}")
    assert caught.value.message.code == "plt.several-scales"


def test_a_window_clips_the_lines() -> None:
    drawing = plot("IW0,0,400,400;PU200,200;PD800,200;IW;PD800,400;")
    assert_allclose(drawing.ends, [[[5, 5], [10, 5]], [[20, 5], [20, 10]]], atol=1e-9)


# ── Pens ──────────────────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("text", "style"),
    [
        ("", ("pen 1", "Continuous", NO_LINE_WIDTH)),
        ("SP3;", ("pen 3", "Continuous", NO_LINE_WIDTH)),
        ("LT2,4;", ("pen 1", "dashed 2", NO_LINE_WIDTH)),
        ("LT2;LT;", ("pen 1", "Continuous", NO_LINE_WIDTH)),
        ("LT-5;LT;LT99;", ("pen 1", "dashed 5", NO_LINE_WIDTH)),
        ("PW.35;", ("pen 1", "Continuous", 35)),
        ("PW.5,2;PW.7,1;SP2;", ("pen 2", "Continuous", 50)),
        ("WU1;PW.5;", ("pen 1", "Continuous", NO_LINE_WIDTH)),
        ("LT3;PW1;DF;", ("pen 1", "Continuous", NO_LINE_WIDTH)),
    ],
)
def test_pen_line_type_and_width_are_the_style(text: str, style: tuple[str, str, int]) -> None:
    assert styles(plot(text + LINE)) == [style]


@pytest.mark.parametrize(
    ("text", "colour"),
    [
        ("", -1),
        ("PC1,255,0,0;", 0xFF0000),
        ("PC1,255,0,0;PC1;", -1),
        ("PC2,255,0,0;", -1),
        ("CR0,1,0,1,0,1;PC1,0,.5,1;", 0x0080FF),
    ],
)
def test_a_pen_has_the_colour_that_the_file_states(text: str, colour: int) -> None:
    assert plot(text + LINE).true_colour.tolist() == [colour]


def test_lines_before_a_pen_is_selected_are_drawn_and_lines_without_a_pen_are_not() -> None:
    drawing = read(b"IN;PU0,0;PD40,0;SP0;PD40,40;")
    assert drawing.layers == ("no pen",)
    assert drawing.ends.tolist() == [[[0, 0], [1, 0]]]
    assert report_reasons(drawing)[1].startswith("the object is drawn without a pen")


# ── Polygons and encoded polylines ────────────────────────────────────────────────────────────


def test_the_edges_of_a_polygon_are_drawn_and_its_parts_are_closed() -> None:
    outline = "PU0,0;PM0;PD400,0,400,400;PM1;PU100,100;PD200,100,200,200;PM2;"
    drawing = plot(f"{outline}EP;")
    assert_allclose(drawing.lengths.sum(), (10 + 2.5) * (2 + math.sqrt(2)))
    assert len(drawing) == 6
    assert list(drawing.import_report.kind) == ["EP (polygon)"]
    filled = plot(f"{outline}FP;{LINE}")
    assert len(filled) == 1
    assert "filled area" in reasons(filled)["FP (filled polygon)"]


def test_the_pen_is_at_no_known_place_after_a_polygon() -> None:
    drawing = plot("PU0,0;PM0;PD400,0,400,400;PM2;EP;PR;PD40,0;PA;PU0,-40;PD40,-40;")
    edges, relative, absolute = drawing.import_report.length.tolist()
    assert (edges, relative, absolute) == (pytest.approx(20 + 10 * math.sqrt(2)), 0, 1)
    assert "depends on the plotter" in report_reasons(drawing)[1]


def test_a_rotation_between_lines_is_reported() -> None:
    drawing = plot(f"RO90;{LINE}RO;PU0,80;PD40,80;RO;SP0;")
    assert_allclose(drawing.ends, [[[0, 0], [0, 1]], [[0, 2], [1, 2]]], atol=1e-12)
    assert list(drawing.import_report.kind) == ["PD (pen down)", "RO", "PD (pen down)"]
    assert "turn the paper" in report_reasons(drawing)[1]


def test_a_filled_rectangle_is_dropped_and_its_edges_can_be_drawn() -> None:
    drawing = plot("PU0,0;RA400,400;EP;")
    assert len(drawing) == 4
    assert drawing.import_report.outcome.tolist() == [ImportOutcome.DROPPED, ImportOutcome.KEPT]


@pytest.mark.parametrize("seven_bits", [False, True])
def test_an_encoded_polyline_is_relative_unless_flagged(seven_bits: bool) -> None:
    points = [("<=", 400, 80), ("", 4000, 0), ("", -100, -21050), ("<", 40, 40), ("=", 0, 0)]
    drawing = read(b"IN;SP1;" + encoded(points, seven_bits=seven_bits) + b"PU;")
    assert_allclose(
        drawing.ends * 40,
        [
            [[400, 80], [4400, 80]],
            [[4400, 80], [4300, -20970]],
            [[4340, -20930], [0, 0]],
        ],
        atol=1e-9,
    )


def test_an_encoded_polyline_has_fractions_and_pens() -> None:
    text = b"IN;SP1;" + encoded([("<=", 0, 0), ("", 10.25, 0), (":2", 10.5, -0.75)], places=2)
    drawing = read(text)
    expected: list[list[list[float]]] = [[[0, 0], [10.25, 0]], [[10.25, 0], [20.75, -0.75]]]
    assert_allclose(drawing.ends * 40, expected)
    assert [name for name, *_ in styles(drawing)] == ["pen 1", "pen 2"]
    assert list(drawing.import_report.handle) == ["#3", "#3.1"]


@given(
    st.lists(
        st.tuples(
            st.sampled_from(["", "<", "=", "<="]),
            st.integers(-(2**20), 2**20),
            st.integers(-(2**20), 2**20),
        ),
        min_size=1,
        max_size=9,
    ),
    st.booleans(),
)
def test_an_encoded_polyline_equals_the_same_moves(
    points: list[tuple[str, int, int]], seven_bits: bool
) -> None:
    moves = "".join(
        f"{'PA' if '=' in flag else 'PR'};{'PU' if '<' in flag else 'PD'}{x},{y};"
        for flag, x, y in points
    )
    start = b"IN;SP1;EA8,8;"
    packed = read(start + encoded(list(points), seven_bits=seven_bits))
    plain = read(start + moves.encode())
    assert packed.ends.tolist() == plain.ends.tolist()


# ── What is not read ──────────────────────────────────────────────────────────────────────────


def test_a_label_is_an_annotation_and_the_place_behind_it_is_not_known() -> None:
    drawing = plot("SI.2,.5;PU400,800;LBLid: PD0,0;\x03PR;PD40,0;PA;PU0,0;PD40,0;DT#;LB50#PU;")
    assert [(one.text, one.x, one.y, one.height, one.layer) for one in drawing.annotations] == [
        ("Lid: PD0,0;", 10, 20, 5, "pen 1"),
        ("50", 1, 0, 5, "pen 1"),
    ]
    assert drawing.ends.tolist() == [[[0, 0], [1, 0]]]
    assert list(report_reasons(drawing)) == [
        "the object is a text, which is not cut",
        "the object begins at a position that depends on the plotter, such as the end of a text",
        "the object was imported unchanged",
        "the object is a text, which is not cut",
    ]


@pytest.mark.parametrize("mover", ["LBLid\x03", "CP3,0;"])
def test_relative_moves_do_not_make_the_place_behind_a_label_known(mover: str) -> None:
    drawing = plot(f"{mover}PR;PU40,0;PD40,0;CI40;PA;PU0,40;PD40,40;")
    assert drawing.ends.tolist() == [[[0, 1], [1, 1]]]


@pytest.mark.parametrize(
    ("text", "kind", "words"),
    [
        ("ZQ1,2;", "ZQ", "HPGL does not define"),
        ("SM*;", "SM", "symbols, ticks or characters"),
        ("XT;", "XT", "symbols, ticks or characters"),
        ("UC0,4,99,2,1;", "UC", "symbols, ticks or characters"),
    ],
)
def test_an_instruction_that_is_not_read_is_reported(text: str, kind: str, words: str) -> None:
    drawing = plot(f"{text}SM;{LINE}")
    assert words in reasons(drawing)[kind]
    assert len(drawing) == 1


def test_only_the_first_sheet_is_read() -> None:
    drawing = plot(f"PG;{LINE}PG;{LINE}")
    assert drawing.import_report.outcome.tolist() == [ImportOutcome.KEPT, ImportOutcome.DROPPED]
    assert "sheet 2" in report_reasons(drawing)[1]


def test_a_file_that_ends_inside_a_number_is_reported() -> None:
    assert "end mark ; of the file is missing" in report_reasons(plot("PU0,0;PD400,0,400,4"))[-1]


@pytest.mark.parametrize(
    ("text", "code", "position"),
    [
        ("PU0,0;PD40;", "plt.x-without-y", 14),
        ("PU0,0;PD40,,0;", "plt.bad-number", 14),
        ("PU0,0;PD,40,0;", "plt.bad-number", 14),
        ("PU0,0;PD40,;", "plt.x-without-y", 14),
        ("PU0,0;PD1.2.3,0;", "plt.bad-number", 14),
        ("PU0,0;PD4-,0;", "plt.bad-number", 14),
        ("PU0,0;PD9999999999999999,0;", "plt.bad-number", 14),
        ("PU0,0;PD40,0*;", "plt.damaged", 20),
        ("PU0,0;P40,0;", "plt.damaged", 14),
        ("PU0,0;\x1b!", "plt.damaged", 14),
        ("LBno end;PD40,0;", "plt.cut-short", 8),
        ("PE\x7f", "plt.cut-short", 8),
        ("PE>;", "plt.bad-polyline", 8),
        ("PE\xbf;", "plt.bad-polyline", 8),
        ("AA0,0;", "plt.wrong-count", 8),
        ("AT0,0,1;", "plt.wrong-count", 8),
        ("CI;", "plt.wrong-count", 8),
        ("EA1;", "plt.wrong-count", 8),
        ("EW1,2;", "plt.wrong-count", 8),
        ("BZ1,2,3,4,5;", "plt.wrong-count", 8),
        ("SC1,2,3;", "plt.wrong-count", 8),
        ("SC1,1,2,3;", "plt.bad-scale", 8),
        ("SC1,0,2,3,2;", "plt.bad-scale", 8),
        ("IP0,0,0,9;", "plt.bad-scale", 8),
        ("IP1;", "plt.wrong-count", 8),
        ("IW1,2;", "plt.wrong-count", 8),
        ("SP1,2;", "plt.wrong-count", 8),
        ("PC1,2;", "plt.wrong-count", 8),
    ],
)
def test_a_damaged_instruction_is_refused_with_its_position(
    text: str, code: str, position: int
) -> None:
    with pytest.raises(NotADrawing) as caught:
        plot(text)
    assert caught.value.message.code == code
    assert caught.value.message.arguments["position"] == position
    assert caught.value.hint


@pytest.mark.parametrize("text", ["", "PU;SP0;", "PU100,100;PU0,0;"])
def test_a_plot_without_lines_is_refused(text: str) -> None:
    with pytest.raises(NotADrawing, match="contains no drawing"):
        plot(text)


@pytest.mark.parametrize(
    "text",
    [
        "PU0,0;PD" + "1,1," * 200 + "0,0;",
        "PU0,0;" + "PD1,1,0,0;" * 101,
        "PU0,0;PR;PD" + "1 " * 100_000 + ";",
    ],
)
def test_the_number_of_segments_is_limited(text: str) -> None:
    with pytest.raises(DrawingTooLarge):
        read(f"IN;SP1;{text}".encode(), limits=Limits(segments=200))


def test_the_number_of_objects_is_limited() -> None:
    with pytest.raises(DrawingTooLarge, match="more than 90 elements"):
        read(b"IN;SP1;" * 50, limits=Limits(expanded=90))
    with pytest.raises(DrawingTooLarge, match="more than 9 elements"):
        read(b"IN;SP1;" + b"PU0,0;PD9,9;" * 10, limits=Limits(entities=9))


STATES = (
    "IN; DF; SP1; SP0; SP; PU; PD; PA; PR; PM0; PM1; PM2; EP; FP; CI40; LT2; PG; RO90; LBa\x03 SC; "
    'SC0,40,0,40,2; SC0,9,0,9; IP0,0,9,9; IW0,0,9,9; IW; \x1b.( \x1b%0A \x1b%0B \x1bE CO"a"; SM*; '
    "DT#; LBa#"
)
NUMERIC = "PU PD PA PR AA AR AT RT CI EA ER EW RA WG BZ BR PW PC ZZ"


@given(
    st.lists(
        st.one_of(
            st.sampled_from(STATES.split(" ")),
            st.tuples(
                st.sampled_from(NUMERIC.split()),
                st.lists(st.sampled_from(["0", "-40", "90", ".5", "99999", "1e3", ""]), max_size=7),
            ).map(lambda made: made[0] + ",".join(made[1]) + ";"),
            st.binary(max_size=5).map(lambda part: part.decode("latin-1")),
        ),
        max_size=12,
    )
)
def test_any_plot_is_read_or_refused(parts: list[str]) -> None:
    data = ("IN;SP1;" + "".join(parts)).encode("latin-1")
    drawing = read_or_refused(lambda given: read(given, limits=Limits(segments=500)), data)
    if drawing is not None:
        assert_lengths_add_up(drawing)
