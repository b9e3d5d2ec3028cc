"""machine_table: the pydantic table of the plain properties of a machine."""

from __future__ import annotations

import dataclasses
from typing import Any, get_type_hints

from pydantic import create_model

from knifetip.fields import Table
from knifetip.model.machine_properties import MachineProperties

_HINTS = get_type_hints(MachineProperties, include_extras=True)
_FIELDS: Any = {
    one.name: (_HINTS[one.name], ... if one.default is dataclasses.MISSING else one.default)
    for one in dataclasses.fields(MachineProperties)
}
#: The properties as fields of a file or an answer.
MachineTable = create_model("MachineTable", __base__=Table, **_FIELDS)
