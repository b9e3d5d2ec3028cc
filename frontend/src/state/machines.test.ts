import { expect, test } from "vitest";
import { proposedMachine } from "./machines";

const own = { name: "a-new-one", gateway: "absent" } as const;
const lost = { name: "b-lost", gateway: "absent" } as const;
const demo = { name: "demo-table", gateway: "connected" } as const;

test("a connected machine is proposed before one that never was", () => {
  expect(proposedMachine([own, lost, demo])).toBe("demo-table");
  expect(proposedMachine([own, lost])).toBe("a-new-one");
  expect(proposedMachine([])).toBeNull();
});
