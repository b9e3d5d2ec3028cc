"""Hostile and damaged files: each is refused quickly, with a clear message."""

from __future__ import annotations

import gzip
import time
from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.svg.read import read
from tests.support.reading import read_or_refused
from tests.support.writers.svg_text import SVG, carton, svg


def refused(data: bytes, kind: type[KnifetipError] = NotADrawing, **limits: int) -> str:
    """Check that a file is refused within ten seconds; return the message."""
    begun = time.process_time()
    with pytest.raises(kind) as caught:
        read(data, limits=Limits(**limits))
    assert time.process_time() - begun < 10.0
    assert caught.value.hint
    return caught.value.text


def declared(*declarations: str, body: str = "<path d='M0 0h1' stroke='red'/>") -> bytes:
    return f"<!DOCTYPE svg [{''.join(declarations)}]><svg {SVG}>{body}</svg>".encode()


def test_nested_entities_are_refused_before_expansion() -> None:
    lines = ['<!ENTITY a "ha">']
    for before, name in pairwise("abcdefghij"):
        lines.append(f'<!ENTITY {name} "' + f"&{before};" * 10 + '">')
    assert "contains markup" in refused(declared(*lines, body="<text>&j;</text>"))


def test_a_long_entity_with_many_references_is_refused() -> None:
    body = f'<path d="{"&a;" * 20_000}"/>'
    assert "1,000 characters, which is too long" in refused(
        declared(f'<!ENTITY a "{"x" * 1000}">', body=body)
    )


@pytest.mark.parametrize(
    "declaration",
    [
        '<!ENTITY a SYSTEM "file:///etc/passwd">',
        '<!ENTITY a PUBLIC "x" "http://example.org/x">',
        '<!ENTITY % a SYSTEM "http://example.org/x.dtd">',
    ],
)
def test_entities_that_refer_to_files_are_refused(declaration: str) -> None:
    assert "is not loaded" in refused(declared(declaration, body="<text>&a;</text>"))


def test_parameter_entities_are_refused() -> None:
    assert "contains markup" in refused(declared('<!ENTITY % a "b">'))


def test_entities_of_illustrator_are_read_without_fetching_its_doctype() -> None:
    drawing = read(
        b'<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" '
        b'"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" ['
        b'<!ENTITY ns_svg "http://www.w3.org/2000/svg"><!ENTITY st0 "stroke:#f00;">]>'
        b'<svg xmlns="&ns_svg;" width="9mm" viewBox="0 0 9 9">'
        b'<path style="&st0;" d="M0 0h9"/></svg>'
    )
    assert drawing.true_colour.tolist() == [0xFF0000]


def test_a_use_bomb_is_refused_before_it_is_expanded() -> None:
    groups = ['<g id="g0"><path d="M0 0h1"/></g>']
    for k in range(1, 12):
        uses = f'<use href="#g{k - 1}"/>' * 10
        groups.append(f'<g id="g{k}">{uses}</g>')
    data = svg("<defs>", *groups, "</defs>", '<use href="#g11"/>')
    assert "expand to more than 1,000,000 elements" in refused(data, DrawingTooLarge)


def test_deep_chains_of_use_are_refused() -> None:
    chain = [f'<g id="g{k}"><use href="#g{k + 1}"/></g>' for k in range(5000)]
    message = refused(svg("<defs>", *chain, "</defs>", '<use href="#g0"/>'), DrawingTooLarge)
    assert "nested more than 16 levels deep" in message


def test_deep_nesting_is_refused() -> None:
    data = svg("<g>" * 100_000 + "</g>" * 100_000)
    assert "nested more than 256 levels deep" in refused(data, DrawingTooLarge)
    assert len(read(svg("<g>" * 200 + '<path d="M0 0h1"/>' + "</g>" * 200))) == 1


def test_limits_are_kept() -> None:
    many = svg('<path d="M0 0h1"/>' * 50)
    assert "more than 40 elements" in refused(many, DrawingTooLarge, entities=40)
    lines = svg(f'<path d="M0 0{"h1" * 100}"/>')
    assert "more than 90 lines and curves" in refused(lines, DrawingTooLarge, segments=90)
    curves = svg('<ellipse rx="30" ry="10"/>' * 9)
    assert "more than 90 lines and curves" in refused(curves, DrawingTooLarge, segments=90)
    assert "the limit is 0.0 MB" in refused(many, DrawingTooLarge, bytes=100)
    packed = gzip.compress(b"<svg " + b" " * 10_000_000)
    assert "is larger than 1.0 MB" in refused(packed, DrawingTooLarge, bytes=2**20)
    sheet = svg("<style>" + "".join(f".a{k}{{fill:red}}" for k in range(2001)) + "</style>")
    assert "2,001 rules" in refused(sheet, DrawingTooLarge)


@pytest.mark.parametrize("data", [b"", b"   ", b"<", b"<svg", b"<svg ", b"<?xml", b"<!--"])
def test_a_truncated_file_is_refused(data: bytes) -> None:
    assert "incomplete" in refused(data)


@pytest.mark.parametrize("encoding", ["UTF-X", "utf-7"])
def test_an_encoding_that_cannot_be_read_is_refused(encoding: str) -> None:
    data = f'<?xml version="1.0" encoding="{encoding}"?><svg xmlns="http://www.w3.org/2000/svg"/>'
    assert "is damaged at line 1" in refused(data.encode())


def test_a_file_truncated_anywhere_is_refused() -> None:
    whole = carton()
    for length in range(len(whole)):
        assert "SVG" in refused(whole[:length]) or length == 0


def test_a_packed_file_truncated_anywhere_is_refused() -> None:
    whole = gzip.compress(carton())
    for length in range(2, len(whole), 7):
        assert "compressed SVG" in refused(whole[:length])


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"<html><body/></html>", "outermost element is html instead of svg"),
        (b'<svg xmlns="urn:other"/>', "outermost element is svg instead of svg"),
        (b"<svg></g>", "damaged at line 1"),
        (b"<svg><path d='&nbsp;'/></svg>", "undefined entity"),
        (b"<svg>\xff\xfe</svg>", "not well-formed"),
        (b"\x00\x01\x02", "damaged"),
        (b"\x1f\x8bnonsense", "compressed SVG file (.svgz) is damaged"),
    ],
)
def test_other_files_are_refused_with_their_kind(data: bytes, words: str) -> None:
    assert words in refused(data)


def test_very_long_numbers_are_parsed_quickly() -> None:
    data = svg(
        f'<path d="M{"1" * 100_000} 0h5"/>',
        f'<path d="M0 0h1" transform="{"scale(1) " * 50_000}"/>',
        f'<path d="M0 0h2" style="{"a:b;" * 50_000}"/>',
        f'<polygon points="{"9 " * 50_000}"/>',
        f'<path d="M0 0h3" stroke="{"(" * 50_000}"/>',
        *(f"<style>{text * 20_000}</style>" for text in ("{", "@a{", "/*", "a,")),
    )
    begun = time.process_time()
    assert read(data).lengths.tolist() == [1.0, 2.0, 3.0]
    assert time.process_time() - begun < 10.0


texts = st.one_of(
    st.sampled_from(["1", "1e308", "-1e308", "nan", "inf", "1e-320", "0", "", "1mm", "50%", "x"]),
    st.floats(allow_nan=True).map(repr),
)


# Radii that are too small for the chord are increased, in the second example from 1e-174.
@example([(1, "-0.08", "-934925", "-39639239", "-263996")], "1mm")
@example([(4, "1.1e-174", "9.7e7", "1.8e248", "1.8e248")], "100mm")
@example([(4, "9.5e-163", "1", "1", "1e308")], "1")
@given(st.lists(st.tuples(st.integers(0, 7), texts, texts, texts, texts), max_size=5), texts)
def test_any_numbers_give_a_drawing_or_a_knifetip_error(
    elements: list[tuple[int, str, str, str, str]], side: str
) -> None:
    forms = (
        '<path d="M{0} {1}C{2} {3} {1} {0} {3} {2}"/>',
        '<path d="M{0} {1}A{2} {3} 30 1 0 {3} {2}"/>',
        '<rect x="{0}" y="{1}" width="{2}" height="{3}" rx="{0}"/>',
        '<ellipse cx="{0}" cy="{1}" rx="{2}" ry="{3}"/>',
        '<g transform="matrix({0} {1} {2} {3} 1 1)"><circle r="{0}"/></g>',
        '<svg viewBox="{0} {1} {2} {3}" width="{0}"><line x2="{1}"/></svg>',
        '<text x="{0}" y="{1}" font-size="{2}">{3}</text>',
        '<path transform="rotate({0} {1},{2})" d="M0 0Q{0} {1} {2} {3}t{0} {1}"/>',
    )
    inside = [forms[form].format(*values) for form, *values in elements]
    drawing = read_or_refused(read, svg(*inside, size=f'width="{side}" height="100mm"'))
    if drawing is not None:
        assert abs(drawing.ends).max(initial=0.0) <= 1e7 * 1.001
        assert (abs(drawing.bulge) <= 1.0).all()


@given(st.binary(max_size=200), st.integers(0, 700), st.integers(0, 20))
def test_any_damage_gives_a_drawing_or_a_knifetip_error(noise: bytes, at: int, gone: int) -> None:
    whole = carton()
    read_or_refused(read, whole[:at] + noise + whole[at + gone :])
