/** Keys of commands: as they are matched with an event, and as they are written. */

import { translate } from "../../language/translate";

/** A key as `KeyboardEvent.key` names it, letters in lower case. */
export interface Shortcut {
  readonly key: string;
  /** null: with or without Shift, for characters that need it on some keyboards */
  readonly shift: boolean | null;
  /** Ctrl, or Cmd on a Mac */
  readonly ctrl: boolean;
}

const isLetter = (key: string): boolean => /^[a-z]$/.test(key);

/** A shortcut as `Shift+F` or `Ctrl+Z`; of a character other than a letter, Shift is not asked. */
export function shortcut(text: string): Shortcut {
  const parts = text.split(/\+(?=.)/);
  const last = parts.at(-1) ?? "";
  const key = last.length === 1 ? last.toLowerCase() : last;
  const named = key.length > 1 || isLetter(key);
  const shift = parts.includes("Shift");
  return { key, shift: named ? shift : null, ctrl: parts.includes("Ctrl") };
}

type KeyPress = Pick<KeyboardEvent, "key" | "shiftKey" | "ctrlKey" | "metaKey" | "altKey">;

export function matches({ key, shift, ctrl }: Shortcut, pressed: KeyPress): boolean {
  const name = pressed.key.length === 1 ? pressed.key.toLowerCase() : pressed.key;
  return (
    name === key &&
    !pressed.altKey &&
    (pressed.ctrlKey || pressed.metaKey) === ctrl &&
    (shift === null || pressed.shiftKey === shift)
  );
}

const NAMES: Readonly<Record<string, string>> = {
  Escape: translate("shortcutsDialog.esc"),
  Delete: translate("shortcutsDialog.delete"),
  Enter: translate("keys.enter"),
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  "-": "−",
};

/** A shortcut as the keyboard names it in the language of the page, such as “Strg Umschalt Z”. */
export function shortcutText({ key, shift, ctrl }: Shortcut): string {
  const name = NAMES[key] ?? key.toUpperCase();
  return [ctrl ? translate("keys.ctrl") : "", shift === true ? translate("keys.shift") : "", name]
    .filter((part) => part !== "")
    .join(" ");
}
