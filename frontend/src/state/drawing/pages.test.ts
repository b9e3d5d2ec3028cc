import { describe, expect, it } from "vitest";
import type { Drawing } from "../../api/drawings";
import { pageRead } from "./pages";

const drawing = (...warnings: { code: string; arguments: object }[]) =>
  ({ warnings }) as unknown as Drawing;

describe("pageRead", () => {
  it("is null for a file with one page", () => {
    expect(pageRead(drawing())).toBeNull();
    expect(pageRead(drawing({ code: "import.not-placed", arguments: { page: 3 } }))).toBeNull();
  });

  it("is the page that the warning about other pages names", () => {
    const other = { code: "import.other-pages", arguments: { pages: 4, page: 2 } };
    expect(pageRead(drawing(other))).toBe(2);
  });
});
