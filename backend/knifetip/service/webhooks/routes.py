"""Routes for webhooks: endpoints of other systems, and the deliveries of events to them."""

from __future__ import annotations

from typing import Annotated

from fastapi import Depends, Path, Query, Request, Response

from knifetip.service.components import ServiceDep
from knifetip.service.database.acting import acting_owner
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of, set_next_page
from knifetip.service.http.principal import Principal, PrincipalDep, principal_of
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store
from knifetip.service.webhooks.egress import check_url
from knifetip.service.webhooks.models import (
    DeliveriesQuery,
    DeliveryOut,
    NewWebhookOut,
    RotationIn,
    SentDeliveryOut,
    WebhookIn,
    WebhookOut,
    WebhookPatch,
)
from knifetip.service.webhooks.store import unknown_webhook_error
from knifetip.service.webhooks.tables import Webhook, WebhookDelivery

router = ScopedRouter(prefix="/webhooks", tags=["webhooks"])


def _own_webhook(
    service: ServiceDep,
    principal: PrincipalDep,
    id: Annotated[str, Path(max_length=200, description="Id of the webhook")],
) -> str:
    """Return the id of a webhook if the sender may manage it; otherwise the answer is 404."""
    row = service.store.webhooks.get(id)
    if not _is_own(principal, row):
        raise unknown_webhook_error(id)
    return id


def _is_own(principal: Principal, row: Webhook) -> bool:
    """Return whether a principal may manage a webhook: administrators manage all of them."""
    return AccessScope.ADMIN in principal.scopes or row.owner == acting_owner() != ""


WebhookId = Annotated[str, Depends(_own_webhook)]
DeliveryId = Annotated[str, Path(max_length=200, description="Id of the delivery")]
_HOUR = 3600.0


@router.post("", status_code=201)
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def add_webhook(
    service: ServiceDep, request: Request, response: Response, new: WebhookIn
) -> NewWebhookOut:
    """Add an endpoint to which events of jobs and drawings are sent.

    Only this answer contains the secret with which the requests are signed (Standard Webhooks).
    If the key of the request is limited to a customer or to machines, the endpoint gets the events
    of their jobs and drawings only.
    """
    url = check_url(new.url, private=service.settings.webhook_private)
    who = principal_of(request).name
    row = service.store.webhooks.add(url, new.description, new.event_types, who)
    return _with_secret(service.store, response, row)


@router.get("")
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def list_webhooks(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    wanted: Annotated[ListPage, Query()],
) -> list[WebhookOut]:
    """List the endpoints, oldest first, each with its newest delivery.

    A key with the scope ``webhooks`` gets those that it has added.  The header `Link` contains the
    URL of the next page.
    """
    rows = [row for row in service.store.webhooks.all() if _is_own(principal, row)]
    return [_webhook_out(service.store, row) for row in page_of(request, response, rows, wanted)]


@router.get("/{id}")
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def get_webhook(service: ServiceDep, id: WebhookId) -> WebhookOut:
    """Get an endpoint."""
    return _webhook_out(service.store, service.store.webhooks.get(id))


@router.patch("/{id}")
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def change_webhook(service: ServiceDep, id: WebhookId, patch: WebhookPatch) -> WebhookOut:
    """Change URL, description or event types of an endpoint, or switch it off and on."""
    changes = patch.model_dump(exclude_none=True)
    if patch.url is not None:
        check_url(patch.url, private=service.settings.webhook_private)
    return _webhook_out(service.store, service.store.webhooks.change(id, **changes))


@router.delete("/{id}", status_code=204)
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def delete_webhook(service: ServiceDep, id: WebhookId) -> None:
    """Delete an endpoint and its deliveries."""
    service.store.webhooks.delete(id)


@router.post("/{id}/rotate-secret")
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def rotate_webhook_secret(
    service: ServiceDep, response: Response, id: WebhookId, rotation: RotationIn | None = None
) -> NewWebhookOut:
    """Give an endpoint a new secret; for a time, requests are signed with the former one, too.

    Only this answer contains the new secret.
    """
    overlap = (rotation or RotationIn()).overlap_hours * _HOUR
    row = service.store.webhooks.rotate_secret(id, overlap)
    return _with_secret(service.store, response, row)


@router.post("/{id}/test", status_code=202)
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def test_webhook(service: ServiceDep, id: WebhookId) -> DeliveryOut:
    """Send an event of the type ``webhook.test`` to an endpoint, whatever it subscribes to.

    The list of deliveries shows the result.
    """
    return delivery_out(service.store.webhooks.send_test(id))


@router.get("/{id}/deliveries")
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
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
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def get_webhook_delivery(
    service: ServiceDep, id: WebhookId, delivery: DeliveryId
) -> SentDeliveryOut:
    """Get a delivery with its attempts and the text that is sent."""
    row = service.store.webhooks.delivery(id, delivery)
    return SentDeliveryOut(**dict(delivery_out(row)), payload=row.payload)


@router.post("/{id}/replay", status_code=202)
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
def replay_dead_letters(service: ServiceDep, id: WebhookId) -> list[DeliveryOut]:
    """Send all dead letters of an endpoint again; list what is pending, at most 100, newest first.

    The header ``webhook-id`` of each remains, so that the receiver can recognise it.
    """
    return [delivery_out(row) for row in service.store.webhooks.replay(id)]


@router.post("/{id}/deliveries/{delivery}/replay", status_code=202)
@requires(AccessScope.ADMIN, AccessScope.WEBHOOKS)
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
            "paused_until": store.webhooks.pause_end(row),
            "last_delivery": None if last is None else delivery_out(last),
        }
    )


def _with_secret(store: Store, response: Response, row: Webhook) -> NewWebhookOut:
    response.headers["Cache-Control"] = "no-store"
    response.headers["Location"] = f"/api/webhooks/{row.id}"
    return NewWebhookOut(**dict(_webhook_out(store, row)), secret=row.secret)


def _columns(row: Webhook) -> dict[str, object]:
    calculated = {"last_delivery", "paused_until", "previous_secret_until"}
    names = set(WebhookOut.model_fields) - calculated
    return {name: getattr(row, name) for name in names}


def delivery_out(row: WebhookDelivery) -> DeliveryOut:
    """Return the API model of a delivery."""
    names = ("id", "event_type", "subject", "state", "created", "attempts")
    return DeliveryOut.model_validate(
        {name: getattr(row, name) for name in names}
        | {"next_attempt": max(row.due, row.created) if row.state == "pending" else None}
    )
