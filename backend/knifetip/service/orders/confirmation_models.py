"""Models of what the operator confirms before a machine starts a job."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.model.sheet import Sheet
from knifetip.service.http.message_models import MessageOut
from knifetip.service.orders.models import JobTool


class ToolToConfirm(JobTool):
    """A tool that must be in its station, with its wear."""

    used: float | None = Field(
        description="Length that the tool has worked since its last change (m); null if the "
        "machine no longer has this station"
    )
    life: float | None = Field(description="Length that the tool may work (m); null for no limit")
    warning: Literal["", "near", "over"] = Field(
        description="near: from 90 % of the life on. over: the life is used up, so that also a "
        "machine that feeds its sheets itself waits for the confirmation. Empty: no warning"
    )


class CheckOut(BaseModel):
    """One item that the operator checks at the machine."""

    id: str = Field(
        description="Id for `checked` of the confirmation: board, sheet, unfinished-sheet, "
        "station-1 and so on, table-clear or hands-clear"
    )
    text: str = Field(description="What is checked: the text of `message`")
    message: MessageOut = Field(description="The text as a message with its code and arguments")
    station: int | None = Field(
        description="Number of the station whose tool is checked; null for any other check"
    )


class ConfirmationOut(BaseModel):
    """What the operator checks at the machine, and then confirms."""

    awaited: bool = Field(description="Whether the machine waits for the confirmation now")
    checks: list[CheckOut] = Field(
        description="What the operator checks at the machine, in the order of the work. The "
        "confirmation names the id of each one"
    )
    machine: str = Field(description="Name of the machine")
    board: str = Field(description="Name of the board that must be on the table")
    tools: list[ToolToConfirm] = Field(
        description="Stations that the program uses, with the tools that must be in them"
    )
    placement: tuple[float, float] = Field(
        description="Position on the table of the lower left corner of the drawing: X, Y (mm)"
    )
    sheet: Sheet | None = Field(
        description="Size and position of a sheet that was cut before the job; null for a sheet "
        "that is larger than the drawing"
    )
    copy_number: int = Field(
        alias="copy", description="Number of the copy that starts with the confirmation, from 1"
    )
    copies: int = Field(description="Number of copies of the job")
    first_of_batch: bool = Field(
        description="Whether this is the first sheet of a batch: the run before on this machine "
        "was not completed, or used another board. Then a machine that feeds its sheets itself "
        "waits for the confirmation, too"
    )
    rest_of_sheet: bool = Field(
        description="Whether the begun sheet of an earlier job must lie on the table, unmoved"
    )
    unfinished_sheet: str = Field(
        description="Id of an earlier job whose unfinished sheet may still lie on the table and "
        "must be removed; empty if there is none"
    )
