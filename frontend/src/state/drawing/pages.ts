/** Which page of its file a drawing is. */

import type { Drawing } from "../../api/drawings";

const OTHER_PAGES: readonly string[] = ["import.other-pages", "import.other-pages-lines"];

/** Number of the page that was read; null if the file has no other pages. */
export function pageRead(drawing: Pick<Drawing, "warnings">): number | null {
  const warning = drawing.warnings.find(({ code }) => OTHER_PAGES.includes(code));
  const page = warning?.arguments?.page;
  return typeof page === "number" ? page : null;
}
