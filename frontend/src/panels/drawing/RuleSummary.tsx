/** A rule, read-only. */

import type { Rule } from "../../api/client";
import { messageText } from "../../messages/translateMessage";
import { LINE_STYLES } from "../../state/drawing/palette";
import panels from "../shared/panels.module.css";
import { Swatch } from "../shared/Swatch";
import css from "./profile.module.css";

export function RuleSummary({ rule }: { rule: Rule & { edges?: number } }) {
  const conditions = messageText(rule.conditions);
  return (
    <div className={css.read}>
      <Swatch type={rule.type} />
      <span className={css.readWords} title={conditions}>
        <b>{LINE_STYLES[rule.type].title}</b> {conditions}
      </span>
      <span className={panels.rowCount}>{rule.edges ?? ""}</span>
    </div>
  );
}
