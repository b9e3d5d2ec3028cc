/** Name of the operator on this device, which is sent with everything that an operator does. */

/** Key of the name in the local storage of the browser; empty: the person gave no name. */
const KEY = "knifetip.operator";
/** Key under which older pages kept the name of the person who accepts shortfalls. */
const OLD_KEY = "knifetip.accepted-by";
/** Greatest number of characters that the server accepts. */
export const OPERATOR_LENGTH = 100;

/** The stored name; null if the question was not answered on this device. */
export function storedOperator(): string | null {
  try {
    return localStorage.getItem(KEY) ?? localStorage.getItem(OLD_KEY);
  } catch {
    // The browser forbids storage, or there is none: the name is kept until the page is closed.
    return kept;
  }
}

/** Name for requests; empty if it is not known. */
export const operatorName = (): string => storedOperator() ?? "";

let kept: string | null = null;

/** Keep a name on this device, and return it as it is sent. */
export function storeOperator(name: string): string {
  kept = name.trim().replace(/\s+/g, " ").slice(0, OPERATOR_LENGTH);
  try {
    localStorage.setItem(KEY, kept);
  } catch {
    // See above.
  }
  return kept;
}
