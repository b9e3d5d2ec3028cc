import { expect, test } from "vitest";
import type { Me } from "../api/accounts";
import { roleReason } from "./accounts";

const me = (...scopes: Me["scopes"]): Me => ({
  kind: "user",
  name: "carol",
  sign_in: "password",
  scopes,
  has_admin: true,
});

test("a role permits what it contains, and the reason names the role that is missing", () => {
  expect(roleReason(undefined, "admin")).toBeNull();
  expect(roleReason(me("viewer", "designer"), "designer")).toBeNull();
  expect(roleReason(me("viewer", "designer"), "operator")).toBe(
    "Only operators and administrators can do this. You are signed in as carol (designer).",
  );
  expect(roleReason(me("gateway"), "viewer")).toContain("carol (gateway)");
});
