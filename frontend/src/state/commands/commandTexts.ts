/** Names of the commands in lists. */

import { translate } from "../../language/translate";
import type { Command, Group } from "./commands";
import { shortcutText } from "./keys";

export const GROUP_TITLES: Readonly<Record<Group, string>> = {
  steps: translate("commands.steps"),
  questions: translate("commands.questions"),
  select: translate("commands.select"),
  types: translate("commands.types"),
  tools: translate("commands.tools"),
  view: translate("commands.view"),
  page: translate("commands.page"),
};

/** All keys of a command, such as “7, Delete”; empty if it has none. */
export const keyTexts = ({ keys }: Pick<Command, "keys">): string =>
  keys.map(shortcutText).join(", ");
