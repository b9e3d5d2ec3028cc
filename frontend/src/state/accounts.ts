/** The user of the page, and the users, keys and audit log of the server. */

import { queryOptions, useQuery } from "@tanstack/react-query";
import { accounts, type Me, type UserRole } from "../api/accounts";
import type { Shelf } from "../api/client";
import { ROLE_FOR } from "../api/roles.gen";
import { queryClient } from "./queries";

export const accountQueries = {
  me: () => queryOptions({ queryKey: ["me"], queryFn: ({ signal }) => accounts.me(signal) }),
  users: () =>
    queryOptions({ queryKey: ["users"], queryFn: ({ signal }) => accounts.users(signal) }),
  keys: () => queryOptions({ queryKey: ["keys"], queryFn: ({ signal }) => accounts.keys(signal) }),
  audit: () =>
    queryOptions({
      queryKey: ["audit"],
      queryFn: ({ signal }) => accounts.audit(signal),
      staleTime: 0,
    }),
};

export const useMe = () => useQuery(accountQueries.me()).data;
export const useUsers = () => useQuery(accountQueries.users());
export const useKeys = () => useQuery(accountQueries.keys());
export const useAudit = () => useQuery(accountQueries.audit());

export const refreshUsers = () => queryClient.invalidateQueries(accountQueries.users());
export const refreshKeys = () => queryClient.invalidateQueries(accountQueries.keys());

/** Create the first administrator, and sign in with that account. */
export async function createFirstAdmin(name: string, password: string): Promise<void> {
  await accounts.createUser(name, password, "admin");
  await accounts.signIn(name, password);
  globalThis.location.reload();
}

export async function signOut(): Promise<void> {
  await accounts.signOut();
  globalThis.location.reload();
}

const ROLES: readonly UserRole[] = ["viewer", "designer", "operator", "admin"];
const PLURALS: Readonly<Record<UserRole, string>> = {
  viewer: "users",
  designer: "designers, operators and administrators",
  operator: "operators and administrators",
  admin: "administrators",
};

/** Reason why a user lacks a role; null: the user has it, or is not known yet. */
export function roleReason(me: Me | undefined, role: UserRole): string | null {
  if (me === undefined || me.scopes.includes(role)) return null;
  return `Only ${PLURALS[role]} can do this. You are signed in as ${me.name} (${roleOf(me.scopes)}).`;
}

/** Method and path of a request for which a role is needed. */
export type RestrictedRequest = keyof typeof ROLE_FOR;

/** Reason why the role of the user does not permit a request; null: permitted, or not known yet. */
export const useRefusal = (request: RestrictedRequest): string | null =>
  roleReason(useMe(), ROLE_FOR[request]);

/** Whether the user is known and has the role for a request. */
export const useIsPermitted = (request: RestrictedRequest): boolean => {
  const me = useMe();
  return me !== undefined && roleReason(me, ROLE_FOR[request]) === null;
};

/** The same as `useRefusal`, for code outside of components. */
export const refusalOf = (request: RestrictedRequest): string | null =>
  roleReason(queryClient.getQueryData(accountQueries.me().queryKey), ROLE_FOR[request]);

export const savingOf = (shelf: Shelf) => `PUT /api/v1/${shelf}/{name}` as const;

/** Role of a user: the greatest of the scopes. */
export const roleOf = (scopes: readonly string[]): string =>
  ROLES.findLast((role) => scopes.includes(role)) ?? "gateway";
