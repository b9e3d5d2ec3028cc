/**
 * Texts of the fields of machines, boards and tools, which the server declares in English, by these
 * English texts. A text that is missing here is shown in English.
 */

import { language } from "./language";

export const schemaTexts: Readonly<Record<string, string>> =
  language === "de" ? (await import("./schemaTexts.de")).schemaTexts : {};
