"""Repository of what the drawings of customers teach: line types by look, and refused looks."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, Final

import sqlalchemy as sa

from knifetip.model.customer_answers import Look, TaughtDrawing, use_from_json
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import RefusedLook
from knifetip.service.database.tables import TaughtDrawing as Row

#: Greatest number of drawings of a customer that are considered, the newest ones.
_NEWEST: Final = 50


class CustomerAnswerStore:
    """Repository of what the drawings of customers teach.

    The rows remain when their drawings are deleted, so that a shop may delete old files without
    answering the questions of its customers again.
    """

    def __init__(self, database: Database) -> None:
        self._db = database

    def record(
        self,
        drawing: str,
        customer: str,
        name: str,
        sha256: str,
        uses: Sequence[dict[str, Any]],
        unit: str = "",
    ) -> None:
        """Store the answers that are learned from a drawing, in place of its earlier ones.

        Parameters
        ----------
        drawing
            Id of the drawing.
        customer
            Customer of the drawing; nothing is stored for a drawing without one.
        name, sha256
            Name and SHA-256 of the file.
        uses
            JSON data of the answers that the drawing gives: line types by look (layer, colour and
            line style), see ``customer_answers.use_json``.
        unit
            Unit that a user gave to the file; "" for none.
        """
        with self._db.writing() as session:
            session.execute(sa.delete(Row).where(Row.drawing == drawing))
            if customer and (uses or unit):
                row = Row(
                    drawing=drawing,
                    customer=customer,
                    name=name,
                    sha256=sha256,
                    at=self._db.clock(),
                    uses=list(uses),
                    unit=unit,
                )
                session.add(row)

    def forget(self, drawing: str) -> None:
        """Delete what the drawing with an id teaches."""
        with self._db.writing() as session:
            session.execute(sa.delete(Row).where(Row.drawing == drawing))

    def taught(self, customer: str, other_than: str = "") -> list[TaughtDrawing]:
        """Return the answers of a customer that apply to its other drawings, newest drawing first.

        ``other_than`` is the id of a drawing that is left out.
        """
        query = sa.select(Row).where(Row.customer == customer, Row.drawing != other_than)
        query = query.order_by(Row.at.desc(), Row.drawing).limit(_NEWEST)
        with self._db.reading() as session:
            return [
                TaughtDrawing(row.name, row.sha256, tuple(map(use_from_json, row.uses)), row.unit)
                for row in session.scalars(query)
            ]

    def refused(self, customer: str) -> frozenset[Look]:
        """Return the looks for which a user has switched off the learned answers of a customer."""
        query = sa.select(RefusedLook.look).where(RefusedLook.customer == customer)
        with self._db.reading() as session:
            return frozenset(Look(**look) for look in session.scalars(query))

    def set_refused(self, customer: str, look: Look, refused: bool) -> None:
        """Switch the learned answers of a customer for a look off or on."""
        fields = asdict(look)
        token = hashlib.sha256(json.dumps(fields, sort_keys=True).encode()).hexdigest()
        same = sa.and_(RefusedLook.customer == customer, RefusedLook.token == token)
        with self._db.writing() as session:
            session.execute(sa.delete(RefusedLook).where(same))
            if refused:
                at = self._db.clock()
                session.add(RefusedLook(customer=customer, token=token, look=fields, at=at))
