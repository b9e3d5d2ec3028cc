from __future__ import annotations

import json
import struct

import numpy as np
import pytest

from knifetip.presentation.columns import pack_columns, unpack_columns

COLUMNS = {
    "pose": np.array([[1.5, -2.0, 3.25, 90.0], [0.0, 0.1, 1e9, -0.0]]),
    "motion": np.array([0, 3, 255], np.uint8),
    "source": np.array([-1, 7], np.int32),
    "none": np.empty((0, 2, 2)),
    "drawn": np.array([0.5, 1e-7], np.float32),
}


def test_columns_come_back_as_they_went_in() -> None:
    columns, meta = unpack_columns(
        pack_columns(COLUMNS, {"layer": 'Größe "1"', "placement": [20.0, 20.0]})
    )
    assert meta == {"layer": 'Größe "1"', "placement": [20.0, 20.0]}
    assert list(columns) == list(COLUMNS)
    for name, column in COLUMNS.items():
        assert columns[name].dtype == column.dtype
        np.testing.assert_array_equal(columns[name], column)


def test_the_layout_is_as_the_browser_reads_it() -> None:
    block = pack_columns(COLUMNS, {"ü": 1})
    assert block[:4] == b"KTIP"
    (length,) = struct.unpack("<I", block[4:8])
    start = 8 + length
    assert start % 8 == 0
    header = json.loads(block[8:start].decode("utf-8"))
    # pose takes 64 bytes; motion 3, filled up to 8; source 8.
    assert [column["offset"] for column in header["columns"]] == [0, 64, 72, 80, 80]
    assert [column["dtype"] for column in header["columns"]] == ["<f8", "|u1", "<i4", "<f8", "<f4"]
    assert struct.unpack_from("<d", block, start + 16) == (3.25,)
    assert struct.unpack_from("<i", block, start + 76) == (7,)
    assert len(block) == start + 88


def test_other_bytes_are_refused() -> None:
    with pytest.raises(ValueError, match="KTIP"):
        unpack_columns(b"PK\x03\x04 something else")


def test_a_number_that_json_cannot_say_is_refused_in_the_meta_data() -> None:
    with pytest.raises(ValueError, match="JSON compliant"):
        pack_columns({}, {"seconds": float("nan")})
