import { afterEach, describe, expect, test, vi } from "vitest";
import { ServiceError } from "../../api/errors";
import { type Definition, libraryService } from "../../api/library";
import type { Machine } from "../../api/machines";
import { NO_SHIFT, placesOf, saveCorrection, shifted, withCorrection } from "./toolCheck";

const MACHINE = { name: "mine", title: "Mine", origin: [20, 30], language: "grblhal" } as Machine;
const FIELDS = {
  title: "Mine",
  station: [
    { number: 1, datum: { x: 0, y: 0, z: 0, c: 0 } },
    { number: 3, datum: { x: -60, y: 0.1, z: -1.5, c: 90 } },
  ],
};

afterEach(() => {
  vi.restoreAllMocks();
});

describe("trial corrections", () => {
  test("are sums of steps without errors of rounding, and bounded", () => {
    let shift = NO_SHIFT;
    for (let step = 0; step < 3; step++) shift = shifted(shift, "Y", 0.1);
    expect(shift).toEqual([0, 0.3, 0, 0]);
    expect(shifted(shift, "C", -90)).toEqual([0, 0.3, 0, -20]);
  });
  test("change the datum of their station only", () => {
    expect(withCorrection(FIELDS, 3, [0.2, 0.2, 0, -1])).toEqual({
      ...FIELDS,
      station: [FIELDS.station[0], { number: 3, datum: { x: -59.8, y: 0.3, z: -1.5, c: 89 } }],
    });
  });
});

test("the points are corners of the drawing on the table", () => {
  const drawing = { bounds: [5, 5, 105, 55] } as never;
  expect(placesOf(MACHINE, drawing).map(({ point }) => point)).toEqual([
    [20, 30],
    [5, 30],
    [120, 80],
  ]);
});

test("a correction becomes a new version, based on the version that was read", async () => {
  const read = { version: 4, shipped: false, fields: FIELDS } as unknown as Definition;
  vi.spyOn(libraryService, "definition").mockResolvedValue(read);
  const put = vi.spyOn(libraryService, "putDefinition").mockResolvedValue(read);
  await saveCorrection(MACHINE, 1, [0, 0, 0.25, 0]);
  const [entry, fields, based] = put.mock.calls[0] ?? [];
  expect(entry).toEqual({ shelf: "machines", name: "mine" });
  expect((fields as typeof FIELDS).station[0]?.datum).toEqual({ x: 0, y: 0, z: 0.25, c: 0 });
  expect(based).toMatchObject({ version: 4 });
});

test("a machine of the library is not changed, and the error has a hint", async () => {
  const read = { version: 0, shipped: true, fields: FIELDS } as unknown as Definition;
  vi.spyOn(libraryService, "definition").mockResolvedValue(read);
  const put = vi.spyOn(libraryService, "putDefinition");
  const refused = await saveCorrection(MACHINE, 1, [1, 0, 0, 0]).catch((error) => error);
  expect(refused).toBeInstanceOf(ServiceError);
  expect((refused as ServiceError).problem.hint).toContain("Copy it");
  expect(put).not.toHaveBeenCalled();
});
