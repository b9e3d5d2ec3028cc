/** JSON Schema of a form, from the schema of the server: in the language of the page. */

import type { RJSFSchema } from "@rjsf/utils";
import { schemaTexts } from "../../language/schemaTexts";

/** Keywords whose values are texts for people; the others are for programs. */
const TEXTS: ReadonlySet<string> = new Set(["title", "description", "group", "itemTitles"]);

type Json = unknown;

const isRecord = (value: Json): value is Readonly<Record<string, Json>> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const translated = (value: Json): Json =>
  Array.isArray(value) ? value.map(translated) : (schemaTexts[String(value)] ?? value);

/** A text with a capital, unless it begins with a unit or the symbol of a formula. */
const withCapital = (text: string): string =>
  text.replace(/^\p{Ll}(?=[\p{L}-]{2})/u, (letter) => letter.toUpperCase());

/** The schema with translated texts; a list of fixed length has one schema for each of its items. */
export function formSchema(schema: Json): RJSFSchema {
  return converted(schema) as RJSFSchema;
}

function converted(schema: Json): Json {
  if (Array.isArray(schema)) return schema.map(converted);
  if (!isRecord(schema)) return schema;
  const found = Object.fromEntries(
    Object.entries(schema).map(([keyword, value]) => {
      // Below "properties" and "$defs" are names, which may be those of keywords.
      if (isRecord(value) && ["properties", "$defs"].includes(keyword)) {
        return [
          keyword,
          Object.fromEntries(Object.entries(value).map(([name, one]) => [name, converted(one)])),
        ];
      }
      if (!TEXTS.has(keyword)) return [keyword, converted(value)];
      const text = translated(value);
      return [keyword, keyword === "description" ? withCapital(String(text)) : text];
    }),
  );
  const { minItems, maxItems, items, itemTitles, description, title } = found;
  if (typeof minItems !== "number" || minItems === 0 || minItems !== maxItems) return found;
  const titles = itemTitles as readonly string[] | undefined;
  return {
    ...found,
    items: Array.from({ length: minItems }, (_, at) => ({
      ...(items as object),
      title: titles?.[at] ?? `${title} ${at + 1}`,
      description,
    })),
    additionalItems: false,
  };
}
