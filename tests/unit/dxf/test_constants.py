"""Constants of the fast reader, which does not import ezdxf, compared with those of ezdxf."""

from __future__ import annotations

import numpy as np
from ezdxf.entities.dxfentity import DXFTagStorage
from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.factory import ENTITY_CLASSES
from ezdxf.lldxf.encoding import decode_dxf_unicode, has_dxf_unicode
from ezdxf.lldxf.types import BINARY_DATA, POINT_CODES, TYPE_TABLE
from ezdxf.tools.codepage import codepage_to_encoding

from knifetip.dxf import value_types
from knifetip.dxf.encoding import CODE_PAGES, unescape
from knifetip.dxf.fast_reader import group_codes
from knifetip.dxf.fast_reader.tables import NO_ENTITIES


def test_types_of_group_codes_equal_those_of_ezdxf() -> None:
    types = {float: value_types.DECIMAL, int: value_types.INTEGER, str: value_types.TEXT_VALUE}
    for code, found in enumerate(value_types.TYPE.tolist()):
        expected = types[TYPE_TABLE.get(code, str)]
        assert found == (value_types.HEX if code in BINARY_DATA else expected), code
    assert set(np.flatnonzero(group_codes.IS_POINT).tolist()) == POINT_CODES


def test_records_that_are_no_entities_equal_those_of_ezdxf() -> None:
    accepted = (DXFGraphic, DXFTagStorage)
    assert {
        name for name, kind in ENTITY_CLASSES.items() if not issubclass(kind, accepted)
    } == NO_ENTITIES


def test_code_pages_and_escaped_characters_equal_those_of_ezdxf() -> None:
    assert codepage_to_encoding == CODE_PAGES
    for name in ("CUT", r"\U+5200\U+7ebf_1", r"\U+12", r"\u+5200", r"a\\U+00E4b", r"\U+520g"):
        expected = decode_dxf_unicode(name) if has_dxf_unicode(name) else name
        assert unescape(name) == expected
