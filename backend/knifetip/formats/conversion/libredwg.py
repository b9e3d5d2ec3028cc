"""libredwg: convert DWG files to DXF by the program dwg2dxf of LibreDWG.

LibreDWG is a separate program with a licence of its own (GPL).

The DXF has the version of the DWG file: objects of older versions get lost if ``dwg2dxf`` writes
another one.  Some entities are left out although the program ends well; it only prints them.
"""

from __future__ import annotations

import re
from typing import Final

from knifetip.formats.conversion.converter import Converter, Fault

_SOURCE: Final = "drawing.dwg"
_RESULT: Final = "drawing.dxf"
_ERROR: Final = re.compile(r"^(?:ERROR|READ ERROR)[: ]+([^\r\n]*)", re.MULTILINE)
#: Entities that are not in the DXF: of classes that LibreDWG does not support.
_LOST: Final = re.compile(r"^Warning: Un(?:stable|handled) Class entity \d+ (\w+)", re.MULTILINE)
#: Number of characters of an error that are stated.
_REASON: Final = 80


def _prepare(data: bytes) -> dict[str, bytes]:
    """Return the file that dwg2dxf reads."""
    return {_SOURCE: data}


def _explain(log: str, _data: bytes) -> Fault:
    """Return the last error that dwg2dxf has printed."""
    errors = _ERROR.findall(log)
    return Fault(errors[-1][:_REASON] if errors else "", is_memory="Out of memory" in log)


def _list_losses(log: str) -> list[str]:
    """Return the types of entities that are not in the DXF, and the errors in the DWG file."""
    return _LOST.findall(log) + [error[:_REASON] for error in _ERROR.findall(log)]


LIBREDWG: Final = Converter(
    title="LibreDWG",
    program="dwg2dxf",
    variable="KNIFETIP_DWG2DXF",
    least=(),
    source=_SOURCE,
    result=_RESULT,
    yields="dxf",
    arguments=("-v1", "-y", "-o", _RESULT, _SOURCE),
    prepare=_prepare,
    explain=_explain,
    list_losses=_list_losses,
)
