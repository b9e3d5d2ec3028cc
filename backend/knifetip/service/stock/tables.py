"""Table of the sheets in stock."""

from __future__ import annotations

import sqlalchemy as sa
from sqlalchemy.orm import Mapped, mapped_column

from knifetip.service.database.tables import SERIAL, Base


class StockSheet(Base):
    """Sheets in stock of one board and one size."""

    __tablename__ = "stock_sheet"

    serial: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    created: Mapped[float] = mapped_column(sa.Double)
    board: Mapped[str] = mapped_column(sa.String(80))  #: name of the board; empty for any
    width: Mapped[float] = mapped_column(sa.Double)  #: along X (mm)
    height: Mapped[float] = mapped_column(sa.Double)  #: along Y (mm)
    grain: Mapped[str] = mapped_column(sa.String(1))  #: axis, x or y; empty for unknown
    #: number of sheets; None for as many as needed
    count: Mapped[int | None]
    note: Mapped[str] = mapped_column(sa.String(200))
