from __future__ import annotations

import numpy as np
import pytest

from knifetip.model.words import RepeatedValues, TextSlices

LAYERS = ("CUT", "CREASE", "0")


def test_a_column_of_distinct_strings_behaves_like_a_tuple() -> None:
    column = RepeatedValues(LAYERS, np.array([0, 0, 1, -1], np.int32))
    assert column == ("CUT", "CUT", "CREASE", "0")
    assert list(column) == ["CUT", "CUT", "CREASE", "0"]
    assert column[-2] == "CREASE"
    assert column[1:3] == ("CUT", "CREASE")
    assert np.array(column, dtype=object).tolist() == ["CUT", "CUT", "CREASE", "0"]


def test_a_column_of_one_text_is_split_at_the_ends() -> None:
    column = TextSlices("A1#17ÄA1/B2".encode(), np.array([2, 5, 7, 12], np.int64))
    assert column == ("A1", "#17", "Ä", "A1/B2")
    assert list(column) == [column[row] for row in range(4)]
    assert column != ("A1", "#17", "Ä", "A1/B3")
    assert column != ("A1",)


def test_an_index_past_the_end_is_an_error() -> None:
    column = RepeatedValues(LAYERS, np.array([0], np.int32))
    assert len(column) == 1
    with pytest.raises(IndexError):
        column[1]
    with pytest.raises(IndexError):
        column[-2]
