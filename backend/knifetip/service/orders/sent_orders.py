"""Place an order as it was sent: its file is stored as a drawing, and its job is created."""

from __future__ import annotations

import hashlib

from knifetip.errors import RequestError
from knifetip.service.cartons.drawing import carton_name, draw_carton
from knifetip.service.components import Service
from knifetip.service.database.request_key import RequestKey, fingerprint
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.drawings.requests import Upload, drawing_name, store_upload
from knifetip.service.layouts.requests import store_layout
from knifetip.service.limits.work_queue import RequestIdentity
from knifetip.service.order_details.models import details_columns
from knifetip.service.orders.creation import place_order
from knifetip.service.orders.order_models import JobIn
from knifetip.service.orders.orders_with_files import OrderIn


class SentOrder:
    """An order as it was sent: its fields, and its file if it has one.

    Raises
    ------
    RequestError
        The order has not exactly one of a file, a stored drawing, a carton and a layout.
    """

    def __init__(self, order: OrderIn, name: str = "", content: bytes | None = None) -> None:
        self.order = order
        if order.file is not None:
            if content is not None:
                raise RequestError("request.one-drawing")
            name, content = order.file.name, order.file.decoded()
        given = (content, order.drawing, order.carton, order.layout)
        if sum(one is not None for one in given) != 1:
            raise RequestError("request.one-drawing")
        if order.carton is not None:
            name = carton_name(order.carton, order.board)
        self.name = drawing_name(name)
        self.content = content

    @property
    def is_stored(self) -> bool:
        """Whether the order names a stored drawing."""
        return self.order.drawing is not None

    def key(self, text: str | None) -> RequestKey | None:
        """Return the key of the order with a hash of its content, None without a key."""
        if text is None:
            return None
        return RequestKey(text, self.fingerprint())

    def identity(self, text: str | None) -> RequestIdentity:
        """Return what the order has in common with its repetitions."""
        return RequestIdentity.from_content("order", text, self.fingerprint().encode())

    def fingerprint(self) -> str:
        """Return a hash of the content of the order."""
        digest = hashlib.sha256(self.content or b"").hexdigest()
        # Orders without carton and layout have the hash of earlier versions.
        unused = {name for name in ("carton", "layout") if getattr(self.order, name) is None}
        fields = self.order.model_dump_json(exclude={"file", *unused})
        return fingerprint("order", self.name, digest, fields)


def store_drawing(service: Service, sent: SentOrder, key: str | None) -> Drawing:
    """Return the drawing of an order; its file or layout is stored with the details of the order.

    A carton is drawn first, and stored as its file.
    """
    order, content = sent.order, sent.content
    if order.layout is not None:
        request = None if key is None else RequestKey(key, sent.fingerprint())
        name = order.external_id or "layout"
        return store_layout(service, name, order.layout, details_columns(order), request)
    if order.carton is not None:
        content = draw_carton(service, order.carton, order.board)
    if content is None:
        return service.store.drawings.get(order.drawing or "")
    details = details_columns(order)
    profile = order.profile or "default"
    upload = Upload(sent.name, content, order.unit or "", profile, details=details)
    return store_upload(service, upload, key)


def create_sent_job(
    service: Service, sent: SentOrder, drawing: Drawing, key: RequestKey | None
) -> Job:
    """Return the job of an order; a repeated order returns that of the first."""
    earlier = service.store.jobs.find(key) if key else None
    if earlier is not None:
        return earlier
    return place_order(service, job_order(sent.order, drawing.id), key)


def job_order(order: OrderIn, drawing: str) -> JobIn:
    """Return the order of a job that an order contains, for a stored drawing."""
    choices = order.model_copy(update={"drawing": drawing})
    fields = {name: getattr(choices, name) for name in JobIn.model_fields if name != "revision"}
    return JobIn.model_construct(**fields)
