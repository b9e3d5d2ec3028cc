"""Whole DXF files: drawings by other authors, the import report, attributes, and hostile bytes."""

from __future__ import annotations

import random
import struct
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.dxf.read import read
from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.model.drawing import Drawing, ImportOutcome
from tests.support.drawings import report_reasons
from tests.support.writers.dxf_text import block, dxf, entity, insert, layer, line, tags

#: Error class of each drawing by other authors that is refused.
REFUSED = {"danst0__Box-Generator/template.dxf": NotADrawing}


def reasons(drawing: Drawing) -> dict[str, str]:
    return dict(zip(drawing.import_report.handle, report_reasons(drawing), strict=True))


def count_entities(data: bytes) -> Counter[str]:
    """Return the number of entities of each type in the section ENTITIES, by simple text search."""
    lines = [text.strip() for text in data.decode("latin-1").split("\n")]
    pairs = list(zip(lines[0::2], lines[1::2], strict=False))
    kinds: Counter[str] = Counter()
    inside = False
    for (code, value), (next_code, next_value) in zip(pairs, [*pairs[1:], ("", "")], strict=True):
        if code == "0" and value == "SECTION":
            inside = (next_code, next_value) == ("2", "ENTITIES")
        elif code == "0" and value in ("ENDSEC", "EOF"):
            inside = False
        elif code == "0" and inside and value not in ("VERTEX", "SEQEND"):
            kinds[value] += 1
    return kinds


# ── Drawings by other authors ──────────────────────────────────────────────────────────────────


@pytest.mark.corpus
def test_every_drawing_by_other_authors_is_read_or_refused_as_listed(corpus: Path) -> None:
    files = sorted(path for path in corpus.rglob("*") if path.suffix.lower() == ".dxf")
    assert len(files) >= 99
    refused, mends = {}, []
    for path in files:
        name = str(path.relative_to(corpus))
        data = path.read_bytes()
        try:
            drawing = read(data)
        except KnifetipError as error:
            refused[name] = type(error)
            mends.append(error.hint)
            continue
        import_report = drawing.import_report
        assert all(import_report.reason), name
        assert np.isfinite(drawing.ends).all(), name
        assert (np.abs(drawing.bulge) <= 1.0).all(), name
        assert ((drawing.colour >= 1) & (drawing.colour <= 255)).all(), name
        kept = np.flatnonzero(import_report.outcome == ImportOutcome.KEPT)
        drawn = {row for row in kept.tolist() if import_report.kind[row] != "INSERT"}
        assert set(drawing.entity.tolist()) == drawn, name
        assert_allclose(import_report.length.sum(), drawing.lengths.sum(), rtol=1e-9, err_msg=name)
        if not data.startswith(b"AutoCAD Binary DXF"):
            # Every entity of the sheet has a row; blocks of the layouts may have further rows;
            # handles with a "/" are those of entities inside of an INSERT.
            rows = Counter(
                kind
                for kind, handle in zip(import_report.kind, import_report.handle, strict=True)
                if "/" not in handle and kind != "BLOCK"
            )
            if expected := count_entities(data):
                assert rows >= expected, name
    assert refused == REFUSED
    assert all(mends)


@pytest.mark.corpus
def test_obrary_cube_has_74_lines_on_cuts_and_folds(corpus: Path) -> None:
    folder = corpus / "Obrary__Parametric-Papercraft" / "Interchange-Files"
    drawing = read((folder / "cube.dxf").read_bytes())
    assert len(drawing) == 74
    assert Counter(drawing.import_report.kind) == {"LINE": 74}
    assert set(drawing.layers) == {"CUTS", "FOLDS"}
    assert drawing.unit == ""
    assert drawing.import_report.handle[0] == "#1"
    # CUTS has colour 0 in the layer table, which is invalid and becomes 7; FOLDS has 3.
    by_layer = {drawing.layers[i]: c for i, c in zip(drawing.layer, drawing.colour, strict=True)}
    assert by_layer == {"CUTS": 7, "FOLDS": 3}


@pytest.mark.corpus
@pytest.mark.parametrize(
    "name", ["f0200_B_300x200x150", "f0201_B_400x300x250", "f0203_B_350x250x100"]
)
def test_slotted_cartons_have_two_colours_on_layer_design(corpus: Path, name: str) -> None:
    drawing = read((corpus / "generated__bikinon__RSC-FEFCO-02xx" / f"{name}.dxf").read_bytes())
    assert drawing.layers == ("Design",)
    assert set(drawing.colour.tolist()) == {1, 2}
    assert len(drawing.import_report) == 58
    assert drawing.import_report.handle[0] == "1000"


@pytest.mark.corpus
def test_inkpacking_box_has_the_layers_that_pstoedit_names_after_colours(corpus: Path) -> None:
    path = corpus / "generated__eridur-de__mightyscape-inkpacking" / "box_rwlf.dxf"
    drawing = read(path.read_bytes())
    assert set(drawing.layers) == {"C00-00-00-BLACK", "CFF-00-00"}
    assert Counter(drawing.import_report.kind) == {"POLYLINE": 29}


@pytest.mark.corpus
def test_binary_drawing_reads_like_an_ascii_one(corpus: Path) -> None:
    data = corpus / "mozman__ezdxf" / "integration_tests" / "data"
    drawing = read((data / "bin_dxf_r13.dxf").read_bytes())
    assert drawing.import_report.kind == ("LINE",) * 3
    assert_allclose(drawing.bounds, [335.718, 304.27, 595.878, 439.771], atol=5e-4)


# ── Import report ────────────────────────────────────────────────────────────


def test_same_line_twice_is_merged_and_names_the_survivor() -> None:
    drawing = read(
        dxf(
            line(0, 0, 10, 0, (5, "2F3")),
            line(10, 0, 0, 0, (5, "2F4")),
            line(0, 0, 10, 0, (5, "2F5")),
            line(0, 0, 11, 0, (5, "2F6")),
        )
    )
    assert drawing.handles == ["2F3", "2F6"]
    assert list(drawing.import_report.outcome) == [
        ImportOutcome.KEPT,
        ImportOutcome.MERGED,
        ImportOutcome.MERGED,
        ImportOutcome.KEPT,
    ]
    assert (
        report_reasons(drawing)[1]
        == "the object is drawn twice: it has the same shape and position as 2F3"
    )
    assert_array_equal(drawing.import_report.length, [10, 0, 0, 11])


@pytest.mark.parametrize(
    "other",
    [((62, 2),), ((8, "OTHER"),), ((6, "DASHED"),), ((420, 255),)],
    ids=["colour", "layer", "linetype", "true colour"],
)
def test_same_line_with_another_attribute_stays(other: tuple[tuple[int, int | str]]) -> None:
    drawing = read(dxf(line(0, 0, 10, 0), line(0, 0, 10, 0, *other)))
    assert list(drawing.import_report.outcome) == [ImportOutcome.KEPT, ImportOutcome.KEPT]
    assert len(drawing) == 2


def test_arc_and_its_chord_and_its_mirror_are_three_lines() -> None:
    arc = ((10, 0), (20, 0), (40, 5), (50, 0), (51, 180))
    lower = ((10, 0), (20, 0), (40, 5), (50, 180), (51, 360))
    drawing = read(dxf(entity("ARC", *arc), entity("ARC", *lower), line(5, 0, -5, 0)))
    assert len(drawing) == 3


def test_same_arc_drawn_back_to_front_is_merged() -> None:
    # From east through north to west, and as a polyline from west through north to east.
    arc = entity("ARC", (10, 0), (20, 0), (40, 5), (50, 0), (51, 180))
    back = (
        entity("POLYLINE", (66, 1), (70, 0))
        + entity("VERTEX", (10, -5), (20, 0), (42, -1))
        + entity("VERTEX", (10, 5), (20, 0))
        + tags((0, "SEQEND"))
    )
    drawing = read(dxf(arc, back))
    assert list(drawing.import_report.outcome) == [ImportOutcome.KEPT, ImportOutcome.MERGED]


def test_polyline_with_a_repeated_side_is_kept_with_a_note() -> None:
    square = (
        entity("POLYLINE", (5, "A1"), (66, 1), (70, 0))
        + "".join(entity("VERTEX", (10, x), (20, y)) for x, y in [(0, 0), (10, 0), (10, 10)])
        + tags((0, "SEQEND"))
    )
    drawing = read(dxf(line(0, 0, 10, 0, (5, "B2")), square))
    assert (
        reasons(drawing)["A1"]
        == "the object was imported; note: 1 of the 2 segments of the object "
        "is drawn twice: it lies exactly on B2"
    )
    assert list(drawing.import_report.outcome) == [ImportOutcome.KEPT, ImportOutcome.KEPT]
    assert drawing.handles == ["B2", "A1"]


def test_line_without_length_is_dropped_with_the_measure() -> None:
    drawing = read(dxf(line(5, 5, 5, 5.0000000001), line(0, 0, 1, 0)))
    assert drawing.import_report.outcome[0] == ImportOutcome.DROPPED
    assert report_reasons(drawing)[0].startswith("the length of the object is 0.0000000001, ")
    assert len(drawing) == 1


def test_entities_without_handles_are_numbered_in_the_order_of_the_file() -> None:
    drawing = read(dxf(entity("TEXT", (10, 0), (20, 0), (1, "A")), line(0, 0, 1, 0)))
    assert drawing.import_report.handle == ("#1", "#2")
    assert drawing.import_report.kind == ("TEXT", "LINE")
    assert drawing.handles == ["#2"]


def test_paper_space_is_dropped() -> None:
    drawing = read(dxf(line(0, 0, 10, 0, (67, 1)), line(0, 0, 5, 0)))
    assert report_reasons(drawing) == (
        "the object is in a layout (paper space), not in the model",
        "the object was imported unchanged",
    )


def test_invisible_line_is_dropped() -> None:
    drawing = read(dxf(line(0, 0, 10, 0, (60, 1)), line(0, 0, 5, 0), version="AC1015"))
    assert report_reasons(drawing)[0] == "the object is marked as invisible"


def test_block_that_nothing_places_is_named() -> None:
    drawing = read(dxf(line(0, 0, 1, 0), blocks=(block("SPARE", line(0, 0, 5, 0)),)))
    assert drawing.import_report.kind == ("LINE", "BLOCK")
    assert report_reasons(drawing)[1] == (
        "the file defines the block SPARE with 1 object, but the drawing does not use it"
    )


# ── Attributes ────────────────────────────────────────────────────────────────────────────────


def test_colour_and_linetype_by_layer_come_from_the_layer() -> None:
    drawing = read(
        dxf(
            line(0, 0, 1, 0, (8, "FOLDS")),
            line(0, 0, 2, 0, (8, "FOLDS"), (62, 5), (6, "DOT")),
            line(0, 0, 3, 0, (8, "NOWHERE")),
            layers=(layer("folds", 3, linetype="DASHED"),),
        )
    )
    assert drawing.colour.tolist() == [3, 5, 7]
    assert [drawing.linetypes[i] for i in drawing.linetype] == ["DASHED", "DOT", "Continuous"]
    assert [drawing.layers[i] for i in drawing.layer] == ["FOLDS", "FOLDS", "NOWHERE"]
    assert drawing.true_colour.tolist() == [-1, -1, -1]


def test_true_colour_is_read_beside_the_index() -> None:
    drawing = read(dxf(line(0, 0, 1, 0, (62, 1), (420, 0xFF8000)), version="AC1018"))
    assert drawing.colour.tolist() == [1]
    assert drawing.true_colour.tolist() == [0xFF8000]


def test_block_contents_take_layer_colour_and_linetype_of_their_insert() -> None:
    part = block(
        "PART",
        line(0, 0, 1, 0),  # on layer 0: takes the layer of the INSERT, and that layer's colour
        line(0, 0, 2, 0, (8, "OWN"), (62, 0), (6, "BYBLOCK")),
        line(0, 0, 3, 0, (8, "OWN")),
    )
    drawing = read(
        dxf(
            insert("PART", 0, 0, (8, "CUT"), (62, 6), (6, "DASHED"), (5, "AB")),
            blocks=(part,),
            layers=(layer("CUT", 1), layer("OWN", 2)),
        )
    )
    assert [drawing.layers[i] for i in drawing.layer] == ["CUT", "OWN", "OWN"]
    assert drawing.colour.tolist() == [1, 6, 2]
    assert [drawing.linetypes[i] for i in drawing.linetype] == [
        "CONTINUOUS",
        "DASHED",
        "CONTINUOUS",
    ]
    assert drawing.import_report.handle == ("AB", "AB/#1", "AB/#2", "AB/#3")
    assert drawing.import_report.kind == ("INSERT", "LINE", "LINE", "LINE")


def test_by_block_outside_of_a_block_is_colour_7() -> None:
    assert read(dxf(line(0, 0, 1, 0, (62, 0)))).colour.tolist() == [7]


@pytest.mark.parametrize(
    ("version", "page", "encoding"),
    [
        ("AC1009", None, "utf-8"),
        ("AC1009", "ANSI_1252", "cp1252"),
        ("AC1015", "ANSI_936", "gbk"),
        ("AC1027", "ANSI_1252", "utf-8"),
    ],
)
def test_layer_names_survive_the_encoding(version: str, page: str | None, encoding: str) -> None:
    name = "Rillen_ä" if encoding == "cp1252" else "刀线"
    text = dxf(line(0, 0, 1, 0, (8, name)), version=version).decode()
    if page:
        text = text.replace("9\n$INSUNITS", f"9\n$DWGCODEPAGE\n3\n{page}\n9\n$INSUNITS")
    assert read(text.encode(encoding)).layers == (name,)


def test_letters_spelled_as_code_points_are_read() -> None:
    assert read(dxf(line(0, 0, 1, 0, (8, r"\U+5200\U+7EBF")))).layers == ("刀线",)


# ── INSERT ────────────────────────────────────────────────────────────────────────────────────


def test_insert_moves_scales_and_turns_about_the_base_point() -> None:
    part = block("PART", line(1, 1, 3, 1), base=(1, 1))
    drawing = read(dxf(insert("PART", 10, 20, (41, 2), (42, 2), (50, 90)), blocks=(part,)))
    assert_allclose(drawing.ends, [[[10, 20], [10, 24]]], atol=1e-12)


def test_rows_and_columns_repeat_a_block_and_turn_with_it() -> None:
    part = block("PART", line(0, 0, 1, 0))
    grid = ((70, 3), (71, 2), (44, 10), (45, 100), (50, 90))
    drawing = read(dxf(insert("PART", 0, 0, *grid), blocks=(part,)))
    # Rotated by 90°, columns are above each other and rows to the left of each other.
    starts = {tuple(start) for start in np.round(drawing.ends[:, 0]).tolist()}
    assert starts == {(0, 0), (0, 10), (0, 20), (-100, 0), (-100, 10), (-100, 20)}
    assert report_reasons(drawing) == (
        (
            "the object was imported; note: the object inserts the block PART; the object "
            "inserts the block as a grid of copies (3 columns × 2 rows)"
        ),
        "the object was imported; note: the drawing contains the object 6 times",
    )
    assert_allclose(drawing.import_report.length, [0, 6])


def test_mirrored_insert_turns_arcs_around() -> None:
    part = block("PART", entity("ARC", (10, 0), (20, 0), (40, 5), (50, 0), (51, 90)))
    drawing = read(dxf(insert("PART", 0, 0, (41, -1)), blocks=(part,)))
    assert_allclose(drawing.ends, [[[-5, 0], [0, 5]]], atol=1e-12)
    assert drawing.bulge[0] < 0.0


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (
            insert("NOWHERE"),
            "the object inserts the block 'NOWHERE', which is not defined in the file",
        ),
        (
            insert("PART", 0, 0, (41, 0)),
            "the object has no size, because it is scaled by 0 in X and 1 in Y",
        ),
        (
            insert("PART", 0, 0, (50, "1e999")),
            "the position, scale or rotation of the object is not a number",
        ),
        (
            insert("PART", "1e999", 0),
            "the position, scale or rotation of the object is not a number",
        ),
        (
            insert("PART", 0, 0, (210, 1), (220, 0), (230, 0)),
            "the object is not parallel to the XY plane: its plane is tilted by 90°",
        ),
    ],
)
def test_insert_that_cannot_be_placed_is_dropped(text: str, reason: str) -> None:
    drawing = read(dxf(text, line(0, 0, 1, 0), blocks=(block("PART", line(0, 0, 1, 0)),)))
    assert report_reasons(drawing)[0] == reason
    assert len(drawing) == 1


# ── Hostile bytes ─────────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("data", "word"),
    [
        (b"", "empty"),
        (b" \r\n \n", "empty"),
        (b"\x89PNG\r\n\x1a\n" + bytes(100), "PNG"),
        (b"PK\x03\x04" + bytes(100), "ZIP"),
        (b"%PDF-1.7\n", "PDF"),
        (b"AC1027" + bytes(100), "DWG"),
        (b"<svg xmlns='http://www.w3.org/2000/svg'/>", "SVG"),
        (b"Dear Sir,\nplease cut this.\n", "line 1 is 'Dear Sir,'"),
        (b"0\nLINE\n8\n0\n", "no section"),
        (bytes(1000), "empty"),
        (b"AutoCAD Binary DXF\r\n\x1a\x00", "not a DXF"),
        (b"AutoCAD Binary DXF\r\n\x1a\x00" + bytes(range(256)), "not a DXF"),
    ],
)
def test_other_files_are_refused_with_their_format(data: bytes, word: str) -> None:
    with pytest.raises(NotADrawing, match=word) as caught:
        read(data)
    assert caught.value.hint


def test_file_that_is_cut_short_is_refused() -> None:
    whole = dxf(*(line(0, i, 10, i) for i in range(20)))
    for end in range(whole.index(b"ENTITIES"), whole.rindex(b"ENDSEC"), 7):
        with pytest.raises(NotADrawing):
            read(whole[:end])


def test_file_without_end_mark_but_with_all_its_sections_is_read() -> None:
    whole = dxf(line(0, 0, 10, 0))
    assert len(read(whole.removesuffix(b"0\nEOF\n"))) == 1


def test_byte_order_mark_blank_lines_and_utf_16_are_read() -> None:
    whole = dxf(line(0, 0, 10, 0, (8, "CUT")))
    for data in (b"\xef\xbb\xbf" + whole, b"\n\n" + whole, whole.decode().encode("utf-16")):
        assert read(data).layers == ("CUT",)
    assert read(whole.replace(b"\n", b"\r\n")).layers == ("CUT",)
    assert read(whole.replace(b"\n", b"\r")).layers == ("CUT",)


def test_file_larger_than_the_limit_is_refused_unread() -> None:
    with pytest.raises(DrawingTooLarge, match=r"2\.0 MB large, but the limit is 1\.0 MB"):
        read(bytes(2 * 2**20), limits=Limits(bytes=2**20))


def test_more_entities_than_the_limit_are_refused() -> None:
    many = dxf(*(line(0, i, 10, i) for i in range(11)))
    assert len(read(many, limits=Limits(entities=11))) == 11
    with pytest.raises(
        DrawingTooLarge, match=r"11 entities \(drawn objects\), but the limit is 10"
    ):
        read(many, limits=Limits(entities=10))


def test_more_segments_than_the_limit_are_refused() -> None:
    many = dxf(*(entity("CIRCLE", (10, i), (20, 0), (40, 1)) for i in range(6)))
    assert len(read(many, limits=Limits(segments=12))) == 12
    with pytest.raises(DrawingTooLarge, match="more than 11 lines"):
        read(many, limits=Limits(segments=11))


def bomb(levels: int, columns: int) -> bytes:
    """Return a DXF file with blocks nested ``levels`` deep; each is a ``columns`` × ``columns``
    grid.
    """
    blocks = [block("B0", line(0, 0, 1, 0))]
    grid = ((70, columns), (71, columns), (44, 1), (45, 1))
    for level in range(1, levels):
        blocks.append(block(f"B{level}", insert(f"B{level - 1}", 0, 0, *grid)))
    return dxf(insert(f"B{levels - 1}", 0, 0, *grid), blocks=tuple(blocks))


def test_grids_of_grids_are_counted_before_they_are_expanded() -> None:
    began = time.process_time()
    with pytest.raises(DrawingTooLarge, match="expand to"):
        read(bomb(10, 30000))
    assert time.process_time() - began < 10.0


def test_grid_of_an_empty_block_is_counted_too() -> None:
    grid = ((70, 32000), (71, 32000), (44, 1), (45, 1))
    with pytest.raises(DrawingTooLarge, match="1,024,000,000"):
        read(dxf(insert("VOID", 0, 0, *grid), blocks=(block("VOID"),)))


def test_grid_of_polylines_is_counted_in_segments() -> None:
    part = block("PART", *(entity("CIRCLE", (10, i), (20, 0), (40, 1)) for i in range(10)))
    grid = ((70, 100), (71, 100), (44, 50), (45, 50))
    assert len(read(dxf(insert("PART", 0, 0, *grid), blocks=(part,)))) == 200_000
    with pytest.raises(DrawingTooLarge, match="more than 150,000 lines"):
        read(dxf(insert("PART", 0, 0, *grid), blocks=(part,)), limits=Limits(segments=150_000))


def test_blocks_nested_deeper_than_the_limit_are_refused() -> None:
    assert len(read(bomb(16, 1))) == 1
    with pytest.raises(DrawingTooLarge, match="17 levels deep, but the limit is 16"):
        read(bomb(17, 1))


def test_two_thousand_nested_blocks_do_not_exhaust_the_stack() -> None:
    with pytest.raises(DrawingTooLarge, match="2000 levels deep"):
        read(bomb(2000, 1))


def test_blocks_that_contain_themselves_are_dropped_and_named() -> None:
    blocks = (
        block("A", insert("B"), line(0, 0, 1, 0)),
        block("B", insert("A"), line(0, 0, 2, 0)),
        block("SELF", insert("SELF"), line(0, 0, 3, 0)),
        block("OVER", insert("A"), line(0, 0, 4, 0)),
    )
    drawing = read(dxf(insert("A"), insert("SELF"), insert("OVER"), blocks=blocks))
    assert_array_equal(drawing.lengths, [4])
    assert reasons(drawing)["#1"] == "the block 'A' inserts itself"
    assert reasons(drawing)["#2"] == "the block 'SELF' inserts itself"
    assert reasons(drawing)["#3/#1"] == "the block 'A' inserts itself"


def test_reading_stops_when_its_time_is_up() -> None:
    # An ellipse, because a file of lines is read before the clock advances.
    data = dxf(entity("ELLIPSE", (10, 0), (20, 0), (11, 5), (21, 0), (40, 0.5)))
    with pytest.raises(DrawingTooLarge, match="takes longer than 0 s"):
        read(data, limits=Limits(seconds=0.0))


def test_spline_of_astronomic_size_is_dropped() -> None:
    body: list[tuple[int, object]] = [(70, 8), (71, 3), (72, 8), (73, 4)]
    body += [(40, k) for k in (0, 0, 0, 0, 1, 1, 1, 1)]
    for x, y in [(0, 0), (1e300, 1), (-1e300, 1), (1, 0)]:
        body += [(10, x), (20, y), (30, 0)]
    text = tags((0, "SPLINE"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline"), *body)
    drawing = read(dxf(text, line(0, 0, 1, 0), version="AC1015"))
    assert list(drawing.import_report.outcome) == [ImportOutcome.DROPPED, ImportOutcome.KEPT]


def test_random_damage_ends_in_a_drawing_or_a_refusal() -> None:
    part = block("PART", line(0, 0, 5, 0), entity("CIRCLE", (10, 0), (20, 0), (40, 1)))
    whole = bytearray(
        dxf(
            line(0, 0, 10, 0, (5, "A1")),
            entity("ARC", (10, 0), (20, 0), (40, 10), (50, 0), (51, 270)),
            entity(
                "ELLIPSE", (10, 0), (20, 0), (11, 5), (21, 0), (31, 0), (40, 0.5), (41, 0), (42, 6)
            ),
            insert("PART", 1, 1, (41, 2), (70, 2), (44, 3)),
            blocks=(part,),
            layers=(layer("CUT", -3),),
        )
    )
    dice = random.Random(2024)
    outcomes: Counter[str] = Counter()
    for _ in range(400):
        damaged = bytearray(whole)
        for _ in range(dice.choice([1, 1, 2, 8])):
            at = dice.randrange(len(damaged))
            way = dice.random()
            if way < 0.5:
                damaged[at] = dice.choice(b"0123456789-.eE\n\r \x00\xff9n")
            elif way < 0.75:
                del damaged[at : at + dice.randrange(1, 12)]
            else:
                damaged[at:at] = dice.choice([b"9", b"\n", b"1e308", b"nan", b"-", b"\xe5\x88\x80"])
        try:
            drawing = read(bytes(damaged))
        except KnifetipError as error:
            outcomes[type(error).__name__] += 1
        else:
            outcomes["read"] += 1
            assert np.isfinite(drawing.ends).all()
            assert set(drawing.entity.tolist()) <= set(range(len(drawing.import_report)))
    assert outcomes["read"] > 40
    assert outcomes["NotADrawing"] > 40


def binary(*pairs: tuple[int, object]) -> bytes:
    """Return a binary DXF file of R12: group codes of one byte, doubles, 16-bit integers, texts."""
    data = b"AutoCAD Binary DXF\r\n\x1a\x00"
    for code, value in pairs:
        data += bytes([code])
        if 10 <= code <= 59:
            data += struct.pack("<d", value)
        elif 60 <= code <= 79:
            data += struct.pack("<h", value)
        else:
            data += str(value).encode() + b"\x00"
    return data


def test_binary_drawing_is_read_and_its_damage_refused() -> None:
    whole = binary(
        (0, "SECTION"), (2, "HEADER"), (9, "$INSUNITS"), (70, 1), (0, "ENDSEC"),
        (0, "SECTION"), (2, "ENTITIES"),
        (0, "LINE"), (5, "2F"), (8, "CUT"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0),
        (0, "ENDSEC"), (0, "EOF"),
    )  # fmt: skip
    drawing = read(whole)
    assert (drawing.unit, drawing.layers, drawing.handles) == ("in", ("CUT",), ["2F"])
    assert_array_equal(drawing.ends, [[[0, 0], [254, 0]]])
    for end in range(23, len(whole) - 12):
        with pytest.raises(NotADrawing):
            read(whole[:end])


def test_same_bytes_give_the_same_drawing() -> None:
    data = dxf(line(0, 0, 10, 0), entity("CIRCLE", (10, 0), (20, 0), (40, 3)))
    first, second = read(data), read(data)
    assert first.ends.tobytes() == second.ends.tobytes()
    assert report_reasons(first) == report_reasons(second)
    assert first.import_report.handle == second.import_report.handle
