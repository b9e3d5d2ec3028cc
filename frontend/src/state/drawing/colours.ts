/** Names and display colours of the AutoCAD colour index that drawings use. */

import { translate } from "../../language/translate";

const NAMED: Readonly<Record<number, string>> = {
  1: "#ff4d4d",
  2: "#ffe14d",
  3: "#4dff6a",
  4: "#4de8ff",
  5: "#5b7bff",
  6: "#ff5bff",
  7: "#f2f5f9",
  8: "#8a939e",
  9: "#c3c9d1",
};

const WORDS: Readonly<Record<number, string>> = {
  1: translate("colours.red"),
  2: translate("colours.yellow"),
  3: translate("colours.green"),
  4: translate("colours.cyan"),
  5: translate("colours.blue"),
  6: translate("colours.magenta"),
  7: translate("colours.whiteOrBlack"),
  8: translate("colours.darkGrey"),
  9: translate("colours.lightGrey"),
};

/** Text for a colour index: its number, with its name if it has one. */
export function colourName(index: number): string {
  const word = WORDS[index];
  return word === undefined ? `${index}` : `${index} (${word})`;
}

/** CSS colour for a colour index; 10 to 249 go around the circle of hues. */
export function indexColour(index: number): string {
  const named = NAMED[index];
  if (named !== undefined) return named;
  if (index >= 10 && index < 250) {
    const hue = Math.floor((index - 10) / 10) * 15;
    const light = [62, 74, 50, 60, 40, 50, 32, 42, 26, 34][(index - 10) % 10] ?? 60;
    return `hsl(${hue} 85% ${light}%)`;
  }
  return "#aab3be";
}
