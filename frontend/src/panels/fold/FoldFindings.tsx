/** The faults of the folded board; a click chooses the panels of a fault. */

import type { FoldFinding } from "../../api/folding";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import css from "./fold.module.css";

interface Props {
  readonly findings: readonly FoldFinding[];
  onChoose(finding: FoldFinding): void;
}

export function FoldFindings({ findings, onChoose }: Props) {
  if (findings.length === 0)
    return <p className={css.sound}>{translate("foldFindings.noFaults")}</p>;
  return (
    <ul className={css.findings} data-testid="fold-findings">
      {findings.map((finding) => (
        <li key={`${finding.code} ${finding.panels.join()}`}>
          <button type="button" onClick={() => onChoose(finding)}>
            <strong>{messageText(finding)}</strong>
            <span>{messageHint(finding)}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
