import { expect, test } from "vitest";
import type { Job } from "../../api/jobs";
import { machineWord, proposedMachine } from "./machines";

const own = { name: "a-new-one", gateway: "absent" } as const;
const lost = { name: "b-lost", gateway: "absent" } as const;
const demo = { name: "demo-table", gateway: "connected" } as const;

test("a connected machine is proposed before one that never was", () => {
  expect(proposedMachine([own, lost, demo])).toBe("demo-table");
  expect(proposedMachine([own, lost])).toBe("a-new-one");
  expect(proposedMachine([])).toBeNull();
});

test("a machine whose job waits for a person is not free", () => {
  const there = { gateway: "connected", job: null } as const;
  const waiting = { waiting_for: "confirmation" } as Job;
  const running = { waiting_for: "" } as unknown as Job;
  expect(machineWord(there, undefined)).toBe("free");
  expect(machineWord(there, waiting)).toBe("waiting");
  expect(machineWord({ ...there, job: "j" }, { ...waiting, waiting_for: "sheet" })).toBe("waiting");
  expect(machineWord({ ...there, job: "j" }, running)).toBe("busy");
  expect(machineWord({ ...there, job: "j" }, undefined)).toBe("busy");
  expect(machineWord({ gateway: "absent", job: null }, undefined)).toBe("offline");
});
