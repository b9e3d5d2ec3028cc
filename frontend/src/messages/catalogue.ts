/** Type of a catalogue: a text and a hint for every code, with no other arguments than its own. */

import type { components } from "../api/openapi.gen";
import type { ArgumentsOf as IcuArguments } from "../language/arguments";

export type Message = components["schemas"]["Message"];
export type Code = components["schemas"]["Message"]["code"];
/** Types of the arguments by code; a mapped type, because a search per code exceeds a limit of the compiler. */
type Arguments = { readonly [M in Message as M["code"]]: M["arguments"] };
export type ArgumentsOf<C extends Code> = Arguments[C];

/** An entry in ICU MessageFormat. Without a hint it is empty. */
interface Entry {
  readonly text: string;
  readonly hint: string;
}

/** Names of words in arguments, such as units, by what the words are. */
export type Names = Readonly<Record<string, Readonly<Record<string, string>>>>;

/** The compiler reports codes that a catalogue lacks. */
export type Catalogue = Readonly<Record<Code, Entry>>;

/** The argument from which one with an ending is derived, such as `reason` for `reason__hint`. */
type Given<Name> = Name extends `${infer Sent}__${string}` ? Sent : Name;

/** The codes of a catalogue whose texts name arguments that the code does not have. */
export type Mismatched<T extends Catalogue> = {
  [C in Code]: Given<
    keyof IcuArguments<T[C]["text"]> | keyof IcuArguments<T[C]["hint"]>
  > extends keyof ArgumentsOf<C>
    ? never
    : C;
}[Code];
