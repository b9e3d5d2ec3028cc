"""Routes for webhooks: endpoints of other systems, and the deliveries of events to them."""

from __future__ import annotations

from typing import Annotated

from fastapi import Path, Query, Request, Response

from knifetip.api.egress import check_url
from knifetip.api.principal import principal_of
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.schemas.webhooks import (
    DeliveriesQuery,
    DeliveryOut,
    NewWebhookOut,
    RotationIn,
    SentDeliveryOut,
    WebhookIn,
    WebhookOut,
    WebhookPatch,
)
from knifetip.api.service import ServiceDep, set_next_page
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.store import Store
from knifetip.jobs.webhook_tables import Webhook, WebhookDelivery

router = ScopedRouter(prefix="/webhooks", tags=["webhooks"])

WebhookId = Annotated[str, Path(max_length=200, description="Id of the webhook")]
DeliveryId = Annotated[str, Path(max_length=200, description="Id of the delivery")]
_HOUR = 3600.0


@router.post("", status_code=201)
@requires(AccessScope.ADMIN)
def add_webhook(
    service: ServiceDep, request: Request, response: Response, new: WebhookIn
) -> NewWebhookOut:
    """Add an endpoint to which events of jobs and drawings are sent.

    Only this answer contains the secret with which the requests are signed (Standard Webhooks).
    """
    url = check_url(new.url, private=service.settings.webhook_private)
    who = principal_of(request).name
    row = service.store.webhooks.add(url, new.description, new.event_types, who)
    response.headers["Location"] = f"/api/webhooks/{row.id}"
    return _with_secret(service.store, row)


@router.get("")
@requires(AccessScope.ADMIN)
def list_webhooks(service: ServiceDep) -> list[WebhookOut]:
    """List the endpoints, oldest first, each with its newest delivery."""
    return [_webhook_out(service.store, row) for row in service.store.webhooks.all()]


@router.get("/{id}")
@requires(AccessScope.ADMIN)
def get_webhook(service: ServiceDep, id: WebhookId) -> WebhookOut:
    """Get an endpoint."""
    return _webhook_out(service.store, service.store.webhooks.get(id))


@router.patch("/{id}")
@requires(AccessScope.ADMIN)
def change_webhook(service: ServiceDep, id: WebhookId, patch: WebhookPatch) -> WebhookOut:
    """Change URL, description or event types of an endpoint, or switch it off and on."""
    changes = patch.model_dump(exclude_none=True)
    if patch.url is not None:
        check_url(patch.url, private=service.settings.webhook_private)
    return _webhook_out(service.store, service.store.webhooks.change(id, **changes))


@router.delete("/{id}", status_code=204)
@requires(AccessScope.ADMIN)
def delete_webhook(service: ServiceDep, id: WebhookId) -> None:
    """Delete an endpoint and its deliveries."""
    service.store.webhooks.delete(id)


@router.post("/{id}/rotate-secret")
@requires(AccessScope.ADMIN)
def rotate_webhook_secret(
    service: ServiceDep, id: WebhookId, rotation: RotationIn | None = None
) -> NewWebhookOut:
    """Give an endpoint a new secret; for a time, requests are signed with the former one, too.

    Only this answer contains the new secret.
    """
    overlap = (rotation or RotationIn()).overlap_hours * _HOUR
    return _with_secret(service.store, service.store.webhooks.rotate_secret(id, overlap))


@router.post("/{id}/test", status_code=202)
@requires(AccessScope.ADMIN)
def test_webhook(service: ServiceDep, id: WebhookId) -> DeliveryOut:
    """Send an event of the type ``webhook.test`` to an endpoint, whatever it subscribes to.

    The list of deliveries shows the result.
    """
    return delivery_out(service.store.webhooks.send_test(id))


@router.get("/{id}/deliveries")
@requires(AccessScope.ADMIN)
def list_webhook_deliveries(
    service: ServiceDep,
    request: Request,
    response: Response,
    id: WebhookId,
    wanted: Annotated[DeliveriesQuery, Query()],
) -> list[DeliveryOut]:
    """List the deliveries to an endpoint with their attempts, newest first, of the last 30 days.

    The header ``Link`` contains the URL of the next page.
    """
    rows = service.store.webhooks.deliveries(id, wanted.state, wanted.cursor, wanted.limit)
    last = rows[-1].serial if len(rows) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return [delivery_out(row) for row in rows]


@router.get("/{id}/deliveries/{delivery}")
@requires(AccessScope.ADMIN)
def get_webhook_delivery(
    service: ServiceDep, id: WebhookId, delivery: DeliveryId
) -> SentDeliveryOut:
    """Get a delivery with its attempts and the text that is sent."""
    row = service.store.webhooks.delivery(id, delivery)
    return SentDeliveryOut(**dict(delivery_out(row)), payload=row.payload)


@router.post("/{id}/replay", status_code=202)
@requires(AccessScope.ADMIN)
def replay_dead_letters(service: ServiceDep, id: WebhookId) -> list[DeliveryOut]:
    """Send all dead letters of an endpoint again; list what is pending, at most 100, newest first.

    The header ``webhook-id`` of each remains, so that the receiver can recognise it.
    """
    return [delivery_out(row) for row in service.store.webhooks.replay(id)]


@router.post("/{id}/deliveries/{delivery}/replay", status_code=202)
@requires(AccessScope.ADMIN)
def replay_webhook_delivery(
    service: ServiceDep, id: WebhookId, delivery: DeliveryId
) -> DeliveryOut:
    """Send a delivery again, whatever its state; its header ``webhook-id`` remains."""
    return delivery_out(service.store.webhooks.replay(id, delivery)[0])


def _webhook_out(store: Store, row: Webhook) -> WebhookOut:
    last = store.webhooks.last_delivery(row)
    return WebhookOut.model_validate(
        {
            **_columns(row),
            "previous_secret_until": store.webhooks.overlap_end(row),
            "last_delivery": None if last is None else delivery_out(last),
        }
    )


def _with_secret(store: Store, row: Webhook) -> NewWebhookOut:
    return NewWebhookOut(**dict(_webhook_out(store, row)), secret=row.secret)


def _columns(row: Webhook) -> dict[str, object]:
    names = set(WebhookOut.model_fields) - {"last_delivery", "previous_secret_until"}
    return {name: getattr(row, name) for name in names}


def delivery_out(row: WebhookDelivery) -> DeliveryOut:
    """Return the API model of a delivery."""
    names = ("id", "event_type", "subject", "state", "created", "attempts")
    return DeliveryOut.model_validate(
        {name: getattr(row, name) for name in names}
        | {"next_attempt": max(row.due, row.created) if row.state == "pending" else None}
    )
