/** A rule that is only read. */

import type { Rule } from "../api/client";
import { LINE_LOOKS } from "../state/palette";
import panels from "./panels.module.css";
import css from "./profile.module.css";
import { Swatch } from "./Swatch";

export function RuleWords({ rule }: { rule: Rule & { edges?: number } }) {
  return (
    <div className={css.read}>
      <Swatch type={rule.type} />
      <span className={css.readWords} title={rule.words}>
        <b>{LINE_LOOKS[rule.type].title}</b> {rule.words}
      </span>
      <span className={panels.rowCount}>{rule.edges ?? ""}</span>
    </div>
  );
}
