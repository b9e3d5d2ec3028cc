"""Table of nestings: what is searched, and the best arrangement so far."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Mapped, mapped_column

from knifetip.messages import Message
from knifetip.service.database.message_column import MessageColumn
from knifetip.service.database.tables import SERIAL, Base


class Nesting(Base):
    """A search for the places of drawings on sheets."""

    __tablename__ = "nesting"

    serial: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    #: account that began it, see ``database.acting``; empty for none
    owner: Mapped[str] = mapped_column(sa.String(80), default="")
    created: Mapped[float] = mapped_column(sa.Double)
    state: Mapped[str] = mapped_column(sa.String(16))  #: see ``NestingState``
    stop_requested: Mapped[bool] = mapped_column(default=False)
    #: until when a running search is alive unless its server renews it (``Database.timer``)
    lease: Mapped[float] = mapped_column(sa.Double)
    request: Mapped[dict[str, Any]] = mapped_column(sa.JSON)
    result: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    #: why it failed
    message: Mapped[Message | None] = mapped_column(MessageColumn, default=None)
