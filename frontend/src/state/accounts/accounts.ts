/** The user of the page, and the users, keys and audit log of the server. */

import { queryOptions, useQuery } from "@tanstack/react-query";
import { type AccessScope, accounts, type Me, type UserRole } from "../../api/accounts";
import type { Shelf } from "../../api/library";
import { SCOPES_FOR } from "../../api/roles.gen";
import { translate } from "../../language/translate";
import { queryClient } from "../queries";

export const accountQueries = {
  me: () => queryOptions({ queryKey: ["me"], queryFn: ({ signal }) => accounts.me(signal) }),
  users: () =>
    queryOptions({ queryKey: ["users"], queryFn: ({ signal }) => accounts.users(signal) }),
  keys: () => queryOptions({ queryKey: ["keys"], queryFn: ({ signal }) => accounts.keys(signal) }),
  devices: (machine: string) =>
    queryOptions({
      queryKey: ["devices", machine],
      queryFn: ({ signal }) => accounts.devices(machine, signal),
    }),
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

export const useDevices = (machine: string, wanted: boolean) =>
  useQuery({ ...accountQueries.devices(machine), enabled: wanted });
export const refreshDevices = (machine: string) =>
  queryClient.invalidateQueries(accountQueries.devices(machine));

export const ROLES: readonly UserRole[] = ["viewer", "designer", "operator", "admin"];
export const ROLE_TITLES: Readonly<Record<UserRole, string>> = {
  viewer: translate("accounts.viewer"),
  designer: translate("accounts.designer"),
  operator: translate("accounts.operator"),
  admin: translate("accounts.admin"),
};
const PLURALS: Readonly<Record<UserRole, string>> = {
  viewer: translate("accounts.users"),
  designer: translate("accounts.designersOperatorsAndAdministrators"),
  operator: translate("accounts.operatorsAndAdministrators"),
  admin: translate("accounts.administrators"),
};

/** Method and path of a request for which a scope is needed. */
export type RestrictedRequest = keyof typeof SCOPES_FOR;

/** Least role whose users have a scope; null: no user has it as a role. */
const leastRole = (scope: AccessScope): UserRole | null =>
  scope === "station" ? "operator" : (ROLES.find((role) => role === scope) ?? null);

/**
 * Reason why the scopes of the sender do not permit a request; null: they do, or are not known yet.
 */
export function refusalFor(me: Me | undefined, request: RestrictedRequest): string | null {
  const needed: readonly AccessScope[] = SCOPES_FOR[request];
  if (me === undefined || needed.some((scope) => me.scopes.includes(scope))) return null;
  const roles = needed.map(leastRole);
  const role = ROLES.find((one) => roles.includes(one)) ?? "admin";
  return translate("accounts.onlyCanDoThis", { role: PLURALS[role], me: whoText(me) });
}

const whoText = ({ kind, name, scopes, machines }: Me): string =>
  kind === "device"
    ? translate("accounts.thisDeviceIsPairedWith", { name, machines: machines.join(", ") })
    : translate("accounts.youAreSignedInAs", { name, scopes: roleTitle(scopes) });

/** The same for the sender of the page. */
export const useRefusal = (request: RestrictedRequest): string | null =>
  refusalFor(useMe(), request);

/** Whether the sender is known and may send a request. */
export const useIsPermitted = (request: RestrictedRequest): boolean => {
  const me = useMe();
  return me !== undefined && refusalFor(me, request) === null;
};

/** The same as `useRefusal`, for code outside of components. */
export const refusalOf = (request: RestrictedRequest): string | null =>
  refusalFor(queryClient.getQueryData(accountQueries.me().queryKey), request);

export const savingOf = (shelf: Shelf) => `PUT /api/v1/${shelf}/{name}` as const;

/** Role of a user: the greatest of the scopes; null if the sender is a program. */
export const roleOf = (scopes: readonly string[]): UserRole | null =>
  ROLES.findLast((role) => scopes.includes(role)) ?? null;

/** Title of the role of a user; for a program the first of its scopes. */
export function roleTitle(scopes: readonly string[]): string {
  const role = roleOf(scopes);
  return role === null ? (scopes[0] ?? translate("accounts.noScope")) : ROLE_TITLES[role];
}
