/** Who uses the page, and the users, keys and audit log of the server. */

import { queryOptions, useQuery } from "@tanstack/react-query";
import { accounts } from "../api/accounts";
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

/** Role of a person: the greatest of the scopes. */
export const roleOf = (scopes: readonly string[]): string =>
  ["admin", "operator", "designer", "viewer"].find((role) => scopes.includes(role)) ?? "gateway";
