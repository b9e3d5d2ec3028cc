"""Repository of the sheets in stock."""

from __future__ import annotations

from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import new_id
from knifetip.errors import NotFound, WrongState
from knifetip.service.database.engine import Database, short
from knifetip.service.stock.tables import StockSheet

#: Most sizes of sheets in stock.
MOST_SIZES: Final = 2000


class StockStore:
    """Repository of the sheets in stock."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def add(self, **columns: Any) -> StockSheet:
        """Store sheets, and return them.

        Parameters
        ----------
        columns
            Columns of the table; ``id`` and ``created`` are added.

        Raises
        ------
        WrongState
            The stock has ``MOST_SIZES`` sizes.
        """
        row = StockSheet(id=new_id(), created=self._db.clock(), **columns)
        with self._db.writing() as session:
            count = session.scalar(sa.select(sa.func.count()).select_from(StockSheet)) or 0
            if count >= MOST_SIZES:
                raise WrongState("stock.too-many", limit=MOST_SIZES)
            session.add(row)
        return row

    def all(self, board: str | None = None) -> list[StockSheet]:
        """Return the sheets, smallest first.

        Parameters
        ----------
        board
            Name of a board: only sheets of it, and those for which no board is stated.
        """
        query = sa.select(StockSheet)
        if board is not None:
            query = query.where(StockSheet.board.in_(("", board)))
        area = StockSheet.width * StockSheet.height
        with self._db.reading() as session:
            return list(session.scalars(query.order_by(area, StockSheet.serial)))

    def set_count(self, id: str, count: int | None) -> StockSheet:
        """Change the number of sheets; None for as many as needed.

        Raises
        ------
        NotFound
            There are no sheets with this id.
        """
        with self._db.writing() as session:
            row = _find(session, id)
            row.count = count
        return row

    def delete(self, id: str) -> None:
        """Delete sheets.

        Raises
        ------
        NotFound
            There are no sheets with this id.
        """
        with self._db.writing() as session:
            session.delete(_find(session, id))


def _find(session: Session, id: str) -> StockSheet:
    row = session.scalar(sa.select(StockSheet).where(StockSheet.id == id))
    if row is None:
        raise NotFound("stock.unknown", id=short(id))
    return row
