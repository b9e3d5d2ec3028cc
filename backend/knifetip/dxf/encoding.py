"""encoding: the character encoding of a DXF.

bytes, header variables -> name of an encoding          text with escapes -> text
"""

from __future__ import annotations

from ezdxf.lldxf.encoding import decode_dxf_unicode, has_dxf_unicode
from ezdxf.tools.codepage import toencoding


def spelled(name: str) -> str:
    """Return a name with the format's own way to write foreign letters, ``\\U+5200``, undone."""
    return decode_dxf_unicode(name) if has_dxf_unicode(name) else name


def encoding_of(data: bytes, variables: dict[str, str]) -> str:
    """Return the encoding of the file's texts.

    From R2007 on it is UTF-8.  Before, the header names a code page, but many programs write
    UTF-8 under a header that says ANSI_1252, or says nothing: what is valid UTF-8 is taken as such.
    """
    if variables.get("$ACADVER", "") >= "AC1021" or data.isascii():
        return "utf-8"
    page = variables.get("$DWGCODEPAGE", "ANSI_1252")
    if page == "ANSI_1252":
        try:
            data.decode("utf-8")
        except UnicodeDecodeError:
            return "cp1252"
        return "utf-8"
    return toencoding(page)
