/** Type of a catalogue: a text and a hint for every code, with no other arguments than its own. */

import type { components } from "../api/openapi.gen";

export type Message = components["schemas"]["Message"];
export type Code = components["schemas"]["Message"]["code"];
/** Types of the arguments by code; a mapped type, because a search per code exceeds a limit of the compiler. */
type Arguments = { readonly [M in Message as M["code"]]: M["arguments"] };
export type ArgumentsOf<C extends Code> = Arguments[C];

/** An entry; `render` describes the format of both templates. Without a hint it is empty. */
interface Entry {
  readonly text: string;
  readonly hint: string;
}

/** The compiler reports codes that a catalogue lacks. */
export type Catalogue = Readonly<Record<Code, Entry>>;

/** Names between the braces of a template. */
type Names<T extends string> = T extends `${string}{${infer Field}}${infer Rest}`
  ? NameOf<Field> | Names<Rest>
  : never;

/** The name of a field, without its conversion and format. */
type NameOf<Field extends string> = Field extends `${infer Name}:${string}`
  ? Name
  : Field extends `${infer Name}!r`
    ? Name
    : Field;

/** The codes of a catalogue whose templates name arguments that the code does not have. */
export type Mismatched<T extends Catalogue> = {
  [C in Code]: Names<T[C]["text"] | T[C]["hint"]> extends keyof ArgumentsOf<C> ? never : C;
}[Code];
