/** Requests about webhooks and their deliveries. */

import type { components } from "./openapi.gen";
import { api, byId, dataOf, type Page, pageOf, uncached } from "./restApi";

type Schemas = components["schemas"];
/** An endpoint of another system to which events are sent. */
export type Webhook = Schemas["WebhookOut"];
export type NewWebhook = Schemas["NewWebhookOut"];
export type WebhookFields = Required<Schemas["WebhookIn"]>;
export type WebhookEvent = WebhookFields["event_types"][number];
export type Delivery = Schemas["DeliveryOut"];
export type SentDelivery = Schemas["SentDeliveryOut"];
export type DeliveryState = Delivery["state"];

export const webhookService = {
  list: (signal?: AbortSignal): Promise<Webhook[]> =>
    dataOf(api.GET("/api/v1/webhooks", uncached(signal))),
  add: (fields: WebhookFields): Promise<NewWebhook> =>
    dataOf(api.POST("/api/v1/webhooks", { body: fields })),
  change: (id: string, changes: Partial<WebhookFields & { active: boolean }>): Promise<Webhook> =>
    dataOf(api.PATCH("/api/v1/webhooks/{id}", { params: byId(id), body: changes })),
  /** Replace the secret; for a time (h) requests are signed with the former one, too. */
  rotateSecret: (id: string, overlap_hours: number): Promise<NewWebhook> =>
    dataOf(
      api.POST("/api/v1/webhooks/{id}/rotate-secret", {
        params: byId(id),
        body: { overlap_hours },
      }),
    ),
  test: (id: string): Promise<Delivery> =>
    dataOf(api.POST("/api/v1/webhooks/{id}/test", { params: byId(id) })),
  deliveries: (
    webhook: string,
    state: DeliveryState | null,
    signal?: AbortSignal,
    cursor: number | null = null,
  ): Promise<Page<Delivery>> =>
    pageOf(
      api.GET("/api/v1/webhooks/{id}/deliveries", {
        params: { ...byId(webhook), query: { state, cursor } },
        ...uncached(signal),
      }),
    ),
  delivery: (webhook: string, delivery: string, signal?: AbortSignal): Promise<SentDelivery> =>
    dataOf(
      api.GET("/api/v1/webhooks/{id}/deliveries/{delivery}", {
        params: { path: { id: webhook, delivery } },
        ...uncached(signal),
      }),
    ),
  replayDelivery: async (webhook: string, delivery: string): Promise<void> => {
    await api.POST("/api/v1/webhooks/{id}/deliveries/{delivery}/replay", {
      params: { path: { id: webhook, delivery } },
    });
  },
  replayDeadLetters: (webhook: string): Promise<Delivery[]> =>
    dataOf(api.POST("/api/v1/webhooks/{id}/replay", { params: byId(webhook) })),
  delete: async (id: string): Promise<void> => {
    await api.DELETE("/api/v1/webhooks/{id}", { params: byId(id) });
  },
};
