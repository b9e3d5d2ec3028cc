"""dialect_of: what differs between the controllers is what their documentation says."""

from __future__ import annotations

import pytest

from knifetip.errors import LibraryError
from knifetip.post.dialect import dialect_of


def test_only_linuxcnc_has_a_tool_table_and_blending():
    assert [dialect_of(name).tool_table for name in ("linuxcnc", "grblhal")] == [
        True,
        False,
    ]
    assert [dialect_of(name).blending for name in ("linuxcnc", "grblhal")] == [
        True,
        False,
    ]


def test_only_grblhal_mixes_degrees_into_the_feed_of_an_arc():
    assert [dialect_of(name).inverse_arcs for name in ("linuxcnc", "grblhal")] == [
        False,
        True,
    ]


def test_an_unknown_name_is_refused():
    with pytest.raises(LibraryError, match="no dialect 'GRBL'"):
        dialect_of("GRBL")
