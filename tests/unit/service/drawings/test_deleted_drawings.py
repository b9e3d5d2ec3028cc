"""A drawing that is deleted while a job is ordered for it, and the other way round."""

from __future__ import annotations

import threading

import pytest
import sqlalchemy as sa

from knifetip.errors import JobError, NotFound, WrongState
from knifetip.model.interpretation import Interpretation
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.orders.store import JobOrder
from knifetip.service.store import Store
from tests.support.job_states import ordered
from tests.support.stored import add_drawing

ORDER = JobOrder("demo-table", "e-flute", Interpretation("mm"))


def test_an_order_of_a_drawing_that_was_deleted_meanwhile_is_refused(store: Store) -> None:
    read = add_drawing(store)
    store.drawings.delete(read.id)
    with pytest.raises(NotFound, match=read.id):
        store.jobs.add(read, ORDER)


def test_a_drawing_whose_order_is_being_stored_is_kept(store: Store) -> None:
    template = ordered(store)
    drawing = add_drawing(store)
    refused: list[JobError] = []

    def delete() -> None:
        try:
            store.drawings.delete(drawing.id)
        except JobError as reason:
            refused.append(reason)

    deleting = threading.Thread(target=delete)
    with store.database.writing() as session:
        columns = {
            one.key: getattr(template, one.key)
            for one in sa.inspect(Job).column_attrs
            if one.key not in ("serial", "lengths")
        }
        session.add(Job(**columns | {"id": "new", "key": None, "drawing": drawing.id}))
        session.flush()
        deleting.start()
        # The deletion waits for this transaction.
        deleting.join(0.5)
        assert deleting.is_alive()
    deleting.join(60.0)
    assert [type(reason) for reason in refused] == [WrongState]
    assert store.drawings.get(drawing.id).id == drawing.id


def test_all_old_drawings_are_deleted_in_batches(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.service.drawings.store._BATCH", 2)
    used = ordered(store).drawing
    lost, *others = [add_drawing(store).id for _ in range(5)]

    def save(id: str) -> None:
        if id == lost:
            raise NotFound("drawing.unknown", drawing=id)

    end = store.database.clock() + 1.0
    assert store.drawings.delete_unused_before(end, save) == len(others)
    with store.database.reading() as session:
        assert set(session.scalars(sa.select(Drawing.id))) == {used, lost}
