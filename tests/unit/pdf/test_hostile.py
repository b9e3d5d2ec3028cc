"""Damaged, truncated and expanding files: refused with a hint, in bounded time and memory."""

from __future__ import annotations

import time
import tracemalloc
import zlib
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.model.drawing import ImportOutcome
from knifetip.pdf.read import read
from tests.support.drawings import report_reasons
from tests.support.reading import read_or_refused
from tests.support.writers.pdf_text import carton, objects, pdf, stream

FEW = Limits(bytes=1 << 20, entities=50, segments=1000, seconds=10.0)
LINE = "0 0 m 9 0 l S "


def form(content: str, entries: str = "") -> bytes:
    return stream(content.encode(), f"/Subtype /Form {entries}")


def page(
    content: bytes, entries: str = "", kids: str = "[3 0 R]", boxes: str = "[0 0 9 9]"
) -> bytes:
    return objects(
        "<</Type /Catalog /Pages 2 0 R>>",
        f"<</Type /Pages /Kids {kids} /Count 1 {entries}>>",
        f"<</Type /Page /Parent 2 0 R /MediaBox {boxes} /Contents 4 0 R>>",
        content,
    )


PLAIN = page(stream(LINE.encode()))
HEX = "/Filter [/ASCIIHexDecode /FlateDecode]"
PACKED = zlib.compress((LINE * 1000).encode())


def flate(data: bytes) -> bytes:
    return (
        f"<</Filter /FlateDecode /Length {len(data)}>>\nstream\n".encode() + data + b"\nendstream"
    )


def nested(depth: int) -> bytes:
    names = " ".join(f"/F{k} {6 + k} 0 R" for k in range(depth))
    more = [form(f"/F{k + 1} Do") for k in range(depth - 1)]
    return pdf("/F0 Do", resources=f"/XObject <<{names}>>", more=[*more, form(LINE)])


def laughs(width: int, depth: int) -> bytes:
    names = " ".join(f"/F{k} {6 + k} 0 R" for k in range(depth))
    more = [form(f"/F{k + 1} Do " * width) for k in range(depth - 1)]
    return pdf("/F0 Do", resources=f"/XObject <<{names}>>", more=[*more, form("1 w")])


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "is not a PDF"),
        (b"%PDF-1.7\n", "is incomplete"),
        (b"%PDF-1.7\n%%EOF", "damaged"),
        (b"\0" * 5000, "is not a PDF"),
        (carton()[:-20], "is incomplete"),
        (carton()[: len(carton()) // 2], "is incomplete"),
        (objects("<</Type /Catalog>>"), "has no page"),
        (objects("<</Type /Catalog /Pages 2 0 R>>", "<</Kids [] /Count 0>>"), "has no page"),
        (objects("<</Type /Catalog /Pages 2 0 R>>", "<</Kids [2 0 R]>>"), "has no page"),
        (objects("<</Type /Catalog /Pages 7 0 R>>"), "has no page"),
        (objects("17"), "damaged"),
        (objects("[" * 5000), "damaged"),
        (pdf(LINE, trailer="/Encrypt <</Filter /Standard /V 1 /R 2>>"), "encrypted"),
        (pdf(LINE, trailer="/Encrypt 3 0 R"), "encrypted"),
        (page(flate(PACKED[:-20])), "is incomplete"),
        (
            page(stream(PACKED.hex().encode()[:-40], "/Filter [/ASCIIHexDecode /FlateDecode]")),
            "is incomplete",
        ),
        (page(flate(PACKED[:40] + b"xxxx" + PACKED[44:])), "is damaged"),
        (page(stream(b"x", "/Filter /NoSuchDecode")), "damaged"),
        (page(b"null"), "is missing"),
        (page(stream(b"(never closed")), "a text string has no closing parenthesis"),
        (page(stream(b"0 0 m [ 9 0 l S")), "an array has no closing bracket"),
        (pdf(""), "contains no drawing"),
        (pdf("", root="/AcroForm <</XFA 3 0 R>>"), "XFA"),
        (pdf("BT (a) Tj ET", page="/PieceInfo <</Illustrator <<>>>>"), "without PDF content"),
    ],
)
def test_files_without_a_drawing_are_refused_with_a_hint(data: bytes, words: str) -> None:
    with pytest.raises(NotADrawing) as caught:
        read(data, limits=FEW)
    assert words in caught.value.text
    assert caught.value.hint


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"%PDF" + b"\0" * (1 << 20), "1.0 MB"),
        (page(flate(zlib.compress(b"\n" * (64 << 20)))), "is larger than 1.0 MB when unpacked"),
        (pdf(LINE * 60), "50 elements"),
        (pdf("0 0 m " + "9 0 l " * 1001 + "S"), "1,000 lines and curves"),
        (pdf("0 0 m " + "1 2 3 4 5 6 c " * 1001 + "S"), "1,000 lines and curves"),
        (pdf("q " * 200_000), "graphics states"),
        (pdf("/a BMC " * 120_000), "nested more than"),
        (nested(18), "nested more than 16 levels deep"),
        (laughs(20, 12), "expand to more than 1.0 MB"),
        (
            page(stream(LINE.encode()), boxes="[0 0 1000000000 900000000]"),
            "away from the origin of the page",
        ),
    ],
)
def test_files_that_are_too_large_are_refused_with_a_hint(data: bytes, words: str) -> None:
    with pytest.raises(DrawingTooLarge) as caught:
        read(data, limits=FEW)
    assert words in caught.value.text
    assert caught.value.hint


def test_an_expansion_bomb_uses_little_memory() -> None:
    bomb = page(flate(zlib.compress(b"0 0 m " * (40 << 20))))
    tracemalloc.start()
    with pytest.raises(DrawingTooLarge):
        read(bomb, limits=FEW)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 16 << 20


def test_a_file_that_takes_too_long_is_refused() -> None:
    with pytest.raises(DrawingTooLarge, match="takes longer than 0 s"):
        read(carton(), limits=Limits(seconds=0.0))


def packed(first: bytes, count: int) -> bytes:
    """Return a file whose catalogue is one of ``count`` objects in an object stream."""
    index = b" ".join(b"%d %d" % (k, k * 2) for k in range(10, 10 + count)) + b" "
    body = stream(index + first * 400_000, f"/Type /ObjStm /N {count} /First {len(index)}")
    table = b"\0\0\0\0\xff" + b"\2\0\0\2\0" + b"\1\0\0\x09\0" + b"\1\0\0\0\0"
    cross = stream(table, "/Type /XRef /Size 4 /W [1 3 1] /Root 1 0 R")
    data = b"%PDF-1.5\n2 0 obj\n" + body + b"\nendobj\n"
    return data + b"3 0 obj\n" + cross + b"\nendobj\nstartxref\n%d\n%%%%EOF\n" % len(data)


def test_a_stream_that_would_take_hours_stops_at_the_time_limit() -> None:
    start = time.process_time()
    with pytest.raises(DrawingTooLarge, match=r"longer than 0\.5 s"):
        read(packed(b"( ", 1990), limits=Limits(seconds=0.5))
    assert time.process_time() - start < 5.0


_STRINGS = b"".join(b"%d 0 obj(\n" % k for k in range(50_000))
_ARRAYS = b"".join(b"%d 0 obj[\n" % k for k in range(50_000))
_TRAILERS = b"trailer<<" * 50_000
_END = b"\ntrailer<</Root 1 0 R>>\nstartxref\n9\n"


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (_STRINGS, "startxref not found"),
        (_ARRAYS, "startxref not found"),
        (_TRAILERS, "startxref not found"),
        (_STRINGS + _END, "Trailer cannot be read"),
        (_ARRAYS + _END, "Trailer cannot be read"),
        (_TRAILERS + _END, "Cannot find Root object"),
    ],
    ids=range(6),
)
def test_files_of_unclosed_objects_are_refused_as_damaged_in_time(
    content: bytes, what: str
) -> None:
    start = time.process_time()
    with pytest.raises(NotADrawing, match=what):
        read(b"%PDF-1.4\n" + content + b"%%EOF", limits=Limits(seconds=0.5))
    assert time.process_time() - start < 5.0


def test_missing_and_circular_references_do_not_affect_other_lines() -> None:
    drawing = read(
        pdf(
            "/Loop CS 1 SCN /Nobody gs /Gone Do /Nobody CS",
            LINE,
            spaces="/Loop 6 0 R",
            resources="/XObject <</Gone 99 0 R>> /ExtGState 98 0 R",
            more=["[/Separation /Cut 6 0 R 6 0 R]"],
        )
    )
    assert len(drawing) == 1


@pytest.mark.parametrize(
    ("numbers", "why"),
    [
        ("1e308 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("NaN 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("inf 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("9" * 400 + " 0", "a coordinate of the object is not a number"),
        (
            "9" * 200 + " 0",
            "a coordinate of the object is 1E200 file units, but the limit is 28,346,500",
        ),
        ("--5 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("(5) 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("/N 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("[5] 0", "the path uses the PDF operator 'l' with a wrong number or type of values"),
        ("1 2 3", "the path uses the PDF operator 'l' with a wrong number or type of values"),
    ],
)
def test_invalid_operands_drop_only_their_path(numbers: str, why: str) -> None:
    drawing = read(pdf(f"0 0 m {numbers} l S {LINE}"))
    assert len(drawing) == 1
    rows = zip(drawing.import_report.kind, report_reasons(drawing), strict=True)
    assert [reason for kind, reason in rows if kind == "path"] == [
        why,
        "the object was imported unchanged",
    ]


@pytest.mark.parametrize("matrix", ["1 0 0 1 0 x cm", "cm", "1 0 0 cm", "(a) 0 0 1 0 0 cm"])
def test_lines_after_an_invalid_matrix_are_dropped(matrix: str) -> None:
    drawing = read(pdf(f"q {matrix} {LINE} Q {LINE}"))
    assert [
        outcome for outcome in drawing.import_report.outcome if outcome == ImportOutcome.KEPT
    ] == [ImportOutcome.KEPT]


def test_operators_without_operands_are_ignored() -> None:
    given = "Q Q EMC ET Tj h W n BDC d gs SCN CS g G K cs scn Do Tf Tm TJ ' \" Td TL sh re v y c f*"
    drawing = read(pdf(given, "d0 [(a)] TJ /x /y BDC", LINE))
    assert drawing.import_report.outcome[-1] == ImportOutcome.KEPT


def check_result(data: bytes) -> None:
    """Check that the bytes give a drawing with finite lines, or a refusal with a hint."""
    limits = Limits(bytes=1 << 20, segments=20_000, seconds=20.0)
    read_or_refused(partial(read, limits=limits), data)


WHOLE = (
    carton(),
    carton(flate=True),
    pdf(
        "/A Do BI /W 1 /H 1 ID x EI /Cut CS 1 SCN 10 10 20 20 re B",
        resources="/XObject <</A 8 0 R>>",
        layers=["Cut", "Crease"],
        default="/OFF [6 0 R]",
        page="/Rotate 90 /UserUnit 2 /CropBox [1 1 200 200]",
        more=[form("q 2 0 0 2 1 1 cm 0 0 m 5 0 5 5 0 5 c s Q", "/BBox [0 0 50 50]")],
    ),
)
#: Keywords of PDF files that are inserted at random positions.
WORDS = """
    << >> [ ] ( ) obj endobj stream endstream R q Q cm Do BT BI % trailer startxref %%EOF 0 -1 1e308
    99999999999999999999 /Kids /Prev /OCGs /Encrypt /Length
"""
PHRASES = ["6 0 R", "4 0 R", "/Filter /FlateDecode", "/Type /ObjStm", "/XRefStm 9", "/W [9 9 9]"]
OPERATORS = """
    q Q cm m l c v y h re S s f B b n W gs CS cs SCN scn G g RG K d w Do BT ET Tf Tm Td Tj TJ BDC
    BMC EMC BI ID EI sh /A /Cut /F1 /OC /L0 [ ] (a) <41>
"""
words = st.sampled_from([*WORDS.split(), *PHRASES]).map(str.encode)


@given(
    st.sampled_from(WHOLE),
    st.lists(
        st.tuples(
            st.floats(0, 1),
            st.integers(0, 30),
            st.one_of(words, st.binary(max_size=8)),
        ),
        min_size=1,
        max_size=6,
    ),
)
def test_a_mutated_file_is_read_or_refused(
    whole: bytes, changes: list[tuple[float, int, bytes]]
) -> None:
    data = bytearray(whole)
    for where, gone, new in changes:
        at = int(where * len(data))
        data[at : at + gone] = new
    check_result(bytes(data))


@given(st.floats(0, 1), st.sampled_from(WHOLE))
def test_a_file_truncated_anywhere_is_refused(where: float, whole: bytes) -> None:
    # The end mark shows that a file is complete; the line end after it may be missing.
    cut = whole[: int(where * (len(whole) - len(b"F\n")))]
    with pytest.raises(NotADrawing):
        read(cut)


@given(st.binary(max_size=400))
def test_any_page_is_read_or_refused(content: bytes) -> None:
    check_result(pdf(content))


tokens = st.lists(
    st.one_of(
        st.sampled_from(OPERATORS.split()),
        st.integers(-(10**9), 10**9).map(str),
        st.floats(-100, 100).map(lambda value: f"{value:.3f}"),
    ),
    max_size=60,
)


@given(tokens)
def test_any_order_of_operators_is_read_or_refused(given_: list[str]) -> None:
    check_result(
        pdf(
            " ".join(given_),
            resources="/XObject <</A 7 0 R>>",
            layers=["Cut"],
            more=[form("0 0 m 9 9 l S /A Do")],
        )
    )


def drawn_forms(page_content: str, *forms: str) -> bytes:
    names = " ".join(f"/F{k} {6 + k} 0 R" for k in range(len(forms)))
    return pdf(page_content, resources=f"/XObject <<{names}>>", more=[form(one) for one in forms])


@pytest.mark.parametrize(
    ("data", "is_allowed"),
    [
        # Elements: painted paths and drawn forms, 50 at most.
        (drawn_forms("/F0 Do " * 25, LINE), True),
        (drawn_forms("/F0 Do " * 26, LINE), False),
        (drawn_forms("/F0 Do/F0 Do " * 2, "/F1 Do " * 5, LINE), True),
        (drawn_forms("/F0 Do/F0 Do " * 3, "/F1 Do " * 5, LINE), False),
        (drawn_forms("/F0 Do", "/F0 Do " * 40 + LINE), True),
        (drawn_forms(LINE * 49), True),
    ],
    ids=["forms", "too many forms", "nested", "too many nested", "in itself", "no form"],
)
def test_copies_of_forms_are_counted_before_they_are_read(data: bytes, is_allowed: bool) -> None:
    if is_allowed:
        assert len(read(data, limits=FEW)) > 0
        return
    with pytest.raises(DrawingTooLarge) as caught:
        read(data, limits=FEW)
    assert caught.value.message.code == "reading.expands-too-far"


def test_forms_that_expand_to_billions_of_lines_are_refused_without_reading_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def interpret(*_: object) -> None:
        raise AssertionError("a content stream was interpreted")

    monkeypatch.setattr("knifetip.pdf.stream.Stream.interpret", interpret)
    with pytest.raises(DrawingTooLarge):
        read(laughs(10, 10))


@pytest.mark.parametrize(
    "data",
    [pdf("1 w " * 36 + LINE), drawn_forms("/F0 Do " * 6 + LINE, "1 w " * 5)],
    ids=["page", "forms"],
)
def test_the_operators_of_a_page_are_limited(data: bytes) -> None:
    assert len(read(data, limits=Limits(operators=39))) == 1
    with pytest.raises(DrawingTooLarge) as caught:
        read(data, limits=Limits(operators=38))
    assert caught.value.message.code == "reading.too-many-elements"
    assert caught.value.message.arguments["limit"] == 38
