"""What all readers refuse in the same way: size, unit, unexpected errors, damaged XML."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from knifetip.errors import DrawingTooLarge, NoSuchUnit, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.formats.refusals import refuse_unexpected
from knifetip.lightburn.read import read as read_lightburn
from knifetip.model.drawing import Drawing
from knifetip.svg.read import read as read_svg


@pytest.mark.parametrize("error", [ValueError, ZeroDivisionError, OverflowError, KeyError])
def test_an_error_of_damaged_data_becomes_a_refusal(error: type[Exception]) -> None:
    with (
        pytest.raises(NotADrawing, match=error.__name__),
        refuse_unexpected(b"", None, Limits(), "SVG"),
    ):
        raise error


def test_other_errors_and_refusals_pass() -> None:
    with pytest.raises(TypeError), refuse_unexpected(b"", None, Limits(), "SVG"):
        raise TypeError
    with pytest.raises(NotADrawing) as caught, refuse_unexpected(b"", "mm", Limits(), "SVG"):
        raise NotADrawing("svg.empty")
    assert caught.value.message.code == "svg.empty"


def test_unit_and_size_are_refused_before_the_file_is_read() -> None:
    with pytest.raises(NoSuchUnit), refuse_unexpected(b"", "ell", Limits(), "SVG"):
        pytest.fail("the body is entered")
    with pytest.raises(DrawingTooLarge), refuse_unexpected(b"12", None, Limits(bytes=1), "SVG"):
        pytest.fail("the body is entered")


@pytest.mark.parametrize(
    ("read", "begin"),
    [
        (read_svg, b'<svg xmlns="http://www.w3.org/2000/svg">\n'),
        (read_lightburn, b"<LightBurnProject>\n"),
    ],
)
def test_damaged_xml_is_refused_with_its_place(read: Callable[..., Drawing], begin: bytes) -> None:
    with pytest.raises(NotADrawing) as caught:
        read(begin + b"<a></b>")
    assert caught.value.message.code == "reading.damaged-at"
    assert caught.value.message.arguments["line"] == 2
    with pytest.raises(NotADrawing) as caught:
        read(begin + b"<a><b/>")
    assert caught.value.message.code == "reading.cut-short"
    assert caught.value.message.arguments["count"] == 3
    with pytest.raises(DrawingTooLarge, match="256 levels"):
        read(begin + b"<g>" * 256)
    with pytest.raises(DrawingTooLarge, match="more than 9 elements"):
        read(begin + b"<g/>" * 9, limits=Limits(entities=9))
