"""Functions that find the two lines of a DXF tag, compared with a scan byte by byte."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.dxf.byte_scan import NO_CODE, bytes_equal, code_at, end_of_line, hash_bytes

#: Words of DXF files, and similar ones.
_SIGNS = st.sampled_from([*b" 0123456789", 10, 13, 9, 15, 16, 65, 0, 127, 128, 138, 141, 255])
_TEXTS = st.lists(_SIGNS, max_size=40).map(bytes)


def _column(text: bytes) -> np.ndarray:
    return np.frombuffer(text, np.uint8)


@given(_TEXTS, st.integers(0, 40))
def test_line_ends_at_the_next_lf_or_cr(text: bytes, first: int) -> None:
    first = min(first, len(text))
    found = re.compile(rb"[\r\n]").search(text, first)
    expected = found.start() if found else len(text)
    assert end_of_line(_column(text), np.uint64(first), np.uint64(len(text))) == expected


@given(
    st.one_of(
        _TEXTS,
        st.builds(
            lambda before, code, after, end, rest: b"%s%d%s%s%s" % (before, code, after, end, rest),
            st.sampled_from([b"", b" ", b"  ", b"   "]),
            st.integers(0, 99_999),
            st.sampled_from([b"", b" ", b"  "]),
            st.sampled_from([b"\n", b"\r\n", b"\r", b""]),
            _TEXTS,
        ),
    )
)
def test_a_group_code_is_the_only_number_on_its_line(text: bytes) -> None:
    code, after = code_at(_column(text), np.uint64(0), np.uint64(len(text)))
    found = re.compile(rb" *(\d{1,4}) *\r?\n").match(text)
    if found:
        assert (code, after) == (int(found[1]), found.end())
    else:
        assert code == NO_CODE


@pytest.mark.parametrize("text", [b"1 2\n", b" 1 \n2", b"\n", b"   \n", b"12", b"-10\n", b"0x1\n"])
def test_other_lines_are_no_group_codes(text: bytes) -> None:
    code, _ = code_at(_column(text), np.uint64(0), np.uint64(len(text)))
    assert code == (1 if text == b" 1 \n2" else NO_CODE)


@given(_TEXTS, _TEXTS, st.sampled_from([b"", b"CUT", b"behind the word"]))
def test_words_are_recognised_at_any_position(one: bytes, other: bytes, rest: bytes) -> None:
    first, second = _column(b"before " + one + rest), _column(other)
    size = len(other)
    there = first[7 : 7 + size].tobytes()
    if len(first) >= 7 + size:
        assert bytes_equal(first, 7, second, 0, size) == (there == other)
    # At the end of a text fewer than eight bytes can be read at once.
    end = _column(rest + one)
    assert hash_bytes(first, 7, 7 + len(one)) == hash_bytes(end, len(rest), len(rest) + len(one))


def test_few_names_have_the_same_hash() -> None:
    names = [f"LAYER_{number}".encode() for number in range(2000)]
    numbers = {int(hash_bytes(_column(name), 0, len(name))) & 0xFFFF for name in names}
    # Expected number of distinct random hashes: 65,536 · (1 - e^(-2000 / 65,536)).
    assert len(numbers) > 1900
