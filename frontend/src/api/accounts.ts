/** Requests about the person who uses the page, users, API keys and the audit log. */

import createClient from "openapi-fetch";
import type { components, paths } from "./openapi.gen";
import { fetchOnce, OWN_PAGE } from "./transport";

type Schemas = components["schemas"];
export type Me = Schemas["MeOut"];
export type User = Schemas["UserOut"];
export type UserRole = User["role"];
export type UserChange = Schemas["UserChangeIn"];
export type PairingCode = Schemas["PairingCodeOut"];
export type ApiKey = Schemas["KeyOut"];
export type NewKey = Required<Schemas["KeyIn"]>;
export type AccessScope = Schemas["AccessScope"];
export type AuditEntry = Schemas["AuditOut"];

const api = createClient<paths>({
  baseUrl: globalThis.location?.origin ?? "http://localhost",
  fetch: fetchOnce,
  headers: OWN_PAGE,
});

const AUDIT_ROWS = 200;

async function read<T>(call: Promise<{ data?: T | undefined }>): Promise<T> {
  return (await call).data as T;
}

export const accounts = {
  me: (signal: AbortSignal): Promise<Me> => read(api.GET("/api/v1/me", { signal })),
  signIn: async (name: string, password: string): Promise<void> => {
    await api.POST("/api/v1/session", { body: { name, password } });
  },
  signOut: async (): Promise<void> => {
    await api.DELETE("/api/v1/session");
  },
  changePassword: async (current: string, chosen: string): Promise<void> => {
    await api.POST("/api/v1/me/password", { body: { current, new: chosen } });
  },
  users: (signal: AbortSignal): Promise<User[]> => read(api.GET("/api/v1/users", { signal })),
  createUser: async (name: string, password: string, role: UserRole): Promise<void> => {
    await api.POST("/api/v1/users", { body: { name, password, role } });
  },
  changeUser: async (name: string, body: UserChange): Promise<void> => {
    await api.PATCH("/api/v1/users/{name}", { params: { path: { name } }, body });
  },
  keys: (signal: AbortSignal): Promise<ApiKey[]> => read(api.GET("/api/v1/keys", { signal })),
  /** The secret of the new key, which cannot be read again. */
  createKey: async (body: NewKey) => (await read(api.POST("/api/v1/keys", { body }))).secret,
  revokeKey: async (id: string): Promise<void> => {
    await api.DELETE("/api/v1/keys/{id}", { params: { path: { id } } });
  },
  /** The browsers that are paired with a machine. */
  devices: (name: string, signal: AbortSignal): Promise<ApiKey[]> =>
    read(api.GET("/api/v1/machines/{name}/devices", { params: { path: { name } }, signal })),
  newPairingCode: (name: string): Promise<PairingCode> =>
    read(api.POST("/api/v1/machines/{name}/pairing-codes", { params: { path: { name } } })),
  audit: (signal: AbortSignal): Promise<AuditEntry[]> =>
    read(api.GET("/api/v1/audit", { params: { query: { limit: AUDIT_ROWS } }, signal })),
};
