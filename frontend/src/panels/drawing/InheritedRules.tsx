/** The rules that a profile takes over from the one it extends; collapsed at first. */

import { Paper } from "@mantine/core";
import { useState } from "react";
import type { Preview } from "../../api/drawings";
import { translate } from "../../language/translate";
import css from "../shared/panels.module.css";
import { Figure } from "../shared/parts";
import { RuleSummary } from "./RuleSummary";

interface Props {
  title: string;
  /** null until the server has counted their edges */
  rules: Preview["rules"] | null;
}

export function InheritedRules({ title, rules }: Props) {
  const [open, setOpen] = useState(false);
  const edges = rules?.reduce((sum, rule) => sum + rule.edges, 0) ?? 0;
  return (
    <Paper style={{ overflow: "hidden" }}>
      <button
        type="button"
        className={css.pick}
        style={{ justifyContent: "space-between" }}
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      >
        <span>{translate("inheritedRules.rulesTakenFromTheProfile", { title })}</span>
        <Figure>
          {rules === null
            ? "…"
            : translate("inheritedRules.rulesEdges", { rules: rules.length, edges })}
        </Figure>
      </button>
      {open &&
        rules?.map((rule, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a profile may have two rules alike
          <RuleSummary key={`${at} ${rule.conditions.text}`} rule={rule} />
        ))}
    </Paper>
  );
}
