/** Every text that a user reads is in the catalogue: no file of the page contains a literal one. */

import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";
import { describe, expect, test } from "vitest";

const SRC = join(dirname(fileURLToPath(import.meta.url)), "..");

/** Attributes and properties whose values no user reads. */
const TECHNICAL = new Set([
  ..."align bd bg c display flex fz hiddenFrom mah mih ml mt p pb spacing verticalSpacing visibleFrom wrap".split(
    " ",
  ),
  ..."accept as autoComplete className classNames color component d dash fill fontFamily gap height".split(
    " ",
  ),
  ..."href htmlFor id inputMode justify key kind name path points position radius rel request role".split(
    " ",
  ),
  ..."scope shadow size stroke style target testId testid tone transform type variant viewBox width".split(
    " ",
  ),
  "fontFamilyMonospace",
  "queryKey",
]);

/** Names, commands, keys and formats, which are the same in every language. */
const ALLOWED: readonly RegExp[] = [
  /^knifetip( user add NAME --role admin)?$/,
  /^(GET|POST|PUT|PATCH|DELETE) \/api\//,
  /^(?:[A-Z+−?[\]]|\s)+$/,
  /^(Arrow(Left|Right|Up|Down)|Escape|Enter|Home|End|Tab|Shift|Files|Backspace|Delete)$/,
  /^(Ctrl|((Ctrl\+)?(Shift\+)?([A-Z]|Enter)\b ?)+)$/,
  /^(If-Match|Accept-Language|Link|ETag|Content-Type|Retry-After|X-Knifetip|NFKD|\w+Error)$/,
  /^(Inter Variable|ui-monospace|"?Inter)/,
  /^https:\/\/erp\.example/,
  // Data of SVG paths and pictures, selectors, colours.
  /^[MLACZHVaclhvz\d\s.,-]+$/,
  /^(data:|hsl\(|linear-gradient|color-mix|input, textarea|button, a)/,
];

/** Modules whose strings are shaders, and descriptions of defects for developers. */
const NOT_READ = /^(viewer|scene|geometry|docs)\//;

const isText = (text: string): boolean =>
  /\p{L}{2}/u.test(text) &&
  (/\p{L}[,.:;]? \p{L}/u.test(text) || /^\s*\p{Lu}\p{Ll}/u.test(text)) &&
  !ALLOWED.some((pattern) => pattern.test(text.trim()));

/** Texts in a file that are no messages, with their lines. */
function literalTexts(name: string, source: string): string[] {
  const file = ts.createSourceFile(name, source, ts.ScriptTarget.Latest, true);
  const found: string[] = [];
  const report = (node: ts.Node, text: string) => {
    const { line } = file.getLineAndCharacterOfPosition(node.getStart());
    found.push(`${name}:${line + 1} ${text.trim().slice(0, 60)}`);
  };
  const visit = (node: ts.Node): void => {
    if (isTechnical(node)) return;
    if (ts.isJsxText(node)) {
      if (/\p{L}{2}/u.test(node.text) && !isUnit(node.text) && !isAllowed(node.text))
        report(node, node.text);
    } else if (ts.isStringLiteralLike(node)) {
      if (isText(node.text) || (isShownAttribute(node) && isWord(node.text)))
        report(node, node.text);
    } else if (ts.isTemplateExpression(node)) {
      const text = [node.head, ...node.templateSpans.map((span) => span.literal)]
        .map((part) => part.text)
        .join("…");
      if (isText(text) || / \p{Ll}{3,}|\p{Ll}{3,} /u.test(text)) {
        if (!isAllowed(text) && !/^\/|\bvar\(|…px|\/api\//.test(text)) report(node, text);
      }
    }
    ts.forEachChild(node, visit);
  };
  ts.forEachChild(file, visit);
  return found;
}

const isAllowed = (text: string): boolean => ALLOWED.some((pattern) => pattern.test(text.trim()));
const isUnit = (text: string): boolean =>
  /^[\s·×,;:()%°]*(mm|cm|min|m|s|h)?[\s·×,;:()%°²]*$/u.test(text);
const isWord = (text: string): boolean =>
  /\p{L}{2}/u.test(text) && !isAllowed(text) && !isUnit(text);

/** A string that is the value of an attribute with a text. */
const isShownAttribute = ({ parent }: ts.Node): boolean =>
  ts.isJsxAttribute(parent) &&
  ["label", "aria-label", "title", "placeholder", "description", "alt"].includes(
    parent.name.getText(),
  );

/** Imports, types, comparisons, identifiers of messages, and values of technical attributes. */
function isTechnical(node: ts.Node): boolean {
  if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node) || ts.isTypeNode(node))
    return true;
  if (ts.isTypeAliasDeclaration(node) || ts.isInterfaceDeclaration(node)) return true;
  if (ts.isJsxAttribute(node)) {
    const name = node.name.getText();
    return TECHNICAL.has(name) || name.startsWith("data-") || isDescribing(name);
  }
  const { parent } = node;
  if (ts.isPropertyAssignment(parent) && parent.initializer === node)
    return TECHNICAL.has(parent.name.getText());
  if (ts.isBinaryExpression(parent)) return /^[!=]==$/.test(parent.operatorToken.getText());
  return (
    ts.isCaseClause(parent) || (ts.isElementAccessExpression(parent) && ts.isStringLiteral(node))
  );
}

/** An ARIA attribute with a state or an identifier. */
const isDescribing = (name: string): boolean =>
  name.startsWith("aria-") && !["aria-label", "aria-description", "aria-valuetext"].includes(name);

describe("literal texts", () => {
  test("are in no file of the page", () => {
    const files = readdirSync(SRC, { recursive: true, encoding: "utf8" }).filter(
      (name) =>
        /\.tsx?$/.test(name) &&
        !/\.(test|gen|d|fixture)\.tsx?$/.test(name) &&
        !/^language\/(en|de|language|schemaTexts\.de)\.ts$/.test(name) &&
        !NOT_READ.test(name),
    );
    expect(files.length).toBeGreaterThan(150);
    const found = files.flatMap((name) =>
      literalTexts(name, readFileSync(join(SRC, name), "utf8")),
    );
    expect(found).toEqual([]);
  });

  test("would be found if there were some", () => {
    const found = (source: string) => literalTexts("a.tsx", source).length;
    expect(found('const a = <p title="Save">Save the job</p>;')).toBe(2);
    expect(found('const a = <Icon aria-label="close" />;')).toBe(1);
    expect(found("const a = `Delete $" + "{name}`;")).toBe(1);
    expect(found('throw new Error("The data is incomplete.");')).toBe(1);
    expect(found('const a = <p className="wide" data-testid="save">{count} mm</p>;')).toBe(0);
    expect(found('const a = translate("job.save"); if (state === "Run it") go();')).toBe(0);
  });
});
