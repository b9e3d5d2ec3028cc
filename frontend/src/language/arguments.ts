/** Names and types of the arguments of a text in ICU MessageFormat, derived by the compiler. */

/** Arguments of a text: the braces in it, and the tags, which become elements. */
export type ArgumentsOf<Text extends string> = {
  readonly [Name in Pairs<Text>[0]]: [Name, number] extends Pairs<Text> ? number : string | number;
};

/** Names of the tags of a text, such as `b` in "<b>never</b>". */
export type TagsOf<Text extends string> = Text extends `${string}</${infer Tag}>${infer Rest}`
  ? Tag | TagsOf<Rest>
  : never;

/** Name and type of each argument; a name that is formatted as a number is one. */
type Pairs<Text extends string> = Extract<Scan<Text, ["text"]>, [string, unknown]>;

/** Inside of what the scan is: the innermost level comes first. */
type Levels = readonly ("text" | "argument")[];

/** Reads a text from brace to brace. */
type Scan<
  Text extends string,
  Level extends Levels,
  Found = never,
> = Text extends `${infer Before}{${infer After}`
  ? Before extends `${string}}${string}`
    ? Close<Text, Level, Found>
    : Level[0] extends "text"
      ? Open<After, Level, Found>
      : // A form of a plural or select.
        Scan<After, ["text", ...Level], Found>
  : Text extends `${string}}${string}`
    ? Close<Text, Level, Found>
    : Found;

type Close<
  Text extends string,
  Level extends Levels,
  Found,
> = Text extends `${string}}${infer Rest}`
  ? Level extends readonly [unknown, ...infer Outer extends Levels]
    ? Scan<Rest, Outer, Found>
    : Found
  : Found;

/** Reads what follows the opening brace of an argument. */
type Open<
  Text extends string,
  Level extends Levels,
  Found,
> = Text extends `${infer Head}}${infer Rest}`
  ? Head extends `${infer Name}, ${infer Format}`
    ? Text extends `${string}, ${infer Inside}`
      ? Scan<
          Inside,
          ["argument", ...Level],
          Found | [Name, Format extends `select${string}` ? string : number]
        >
      : never
    : Scan<Rest, Level, Found | [Head, string]>
  : Found;
