/** A rule, read-only. */

import type { Rule } from "../api/client";
import { renderText } from "../messages/render";
import { LINE_STYLES } from "../state/palette";
import panels from "./panels.module.css";
import css from "./profile.module.css";
import { Swatch } from "./Swatch";

export function RuleSummary({ rule }: { rule: Rule & { edges?: number } }) {
  const conditions = renderText(rule.conditions);
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
