"""Check the fields of an option of the command line whose value has parts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from knifetip.errors import PlanError
from knifetip.fields import InvalidFields, Model, check_fields


def check_option(model: type[Model], option: str, fields: Mapping[str, Any]) -> Model:
    """Return the fields of an option of the command line as a record.

    Raises
    ------
    PlanError
        A field is invalid; the error names the option.
    """
    try:
        return check_fields(model, fields)
    except InvalidFields as reason:
        raise PlanError("command.bad-option", option=option, faults=reason.faults) from None
