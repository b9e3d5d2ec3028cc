import { expect, test } from "vitest";
import type { Me } from "../../api/accounts";
import { refusalFor } from "./accounts";

const me = (...scopes: Me["scopes"]): Me => ({
  kind: "user",
  name: "carol",
  sign_in: "password",
  scopes,
  account: "user:carol",
  customer: "",
  machines: [],
  has_admin: true,
});
const ORDER = "POST /api/v1/jobs";
const RELEASE = "POST /api/v1/jobs/{id}/release";
const START = "POST /api/v1/jobs/{id}/confirm";
const KEYS = "POST /api/v1/keys";

test("a role permits what it contains, and the reason names the role that is missing", () => {
  expect(refusalFor(undefined, KEYS)).toBeNull();
  expect(refusalFor(me("viewer", "designer"), ORDER)).toBeNull();
  expect(refusalFor(me("viewer", "designer"), RELEASE)).toBe(
    "Only operators and administrators can do this. You are signed in as carol (designer).",
  );
  expect(refusalFor(me("gateway"), ORDER)).toContain("carol (gateway)");
});

test("the scope decides, not the role: operators start machines because they have it", () => {
  expect(refusalFor(me("viewer", "designer", "operator", "station"), START)).toBeNull();
  expect(refusalFor(me("viewer", "designer", "operator"), START)).toContain("Only operators");
});

test("a paired device starts its machine, and orders and releases nothing", () => {
  const tablet: Me = {
    ...me("viewer", "station"),
    kind: "device",
    name: "Tablet",
    sign_in: null,
    machines: ["table"],
  };
  expect(refusalFor(tablet, START)).toBeNull();
  expect(refusalFor(tablet, "POST /api/v1/machines/{name}/operations")).toBeNull();
  expect(refusalFor(tablet, "POST /api/v1/jobs/{id}/cancel")).toBeNull();
  for (const request of [ORDER, RELEASE, KEYS] as const) {
    expect(refusalFor(tablet, request)).toContain(
      "This device (Tablet) is paired with table only.",
    );
  }
});
