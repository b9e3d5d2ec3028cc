/** Edges that earlier drawings of the customer, or other answers in this drawing, have decided. */

import { IconHistory } from "@tabler/icons-react";
import { useMemo } from "react";
import type { Drawing, LearnedLook, TaughtLook } from "../../api/client";
import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { useIsPermitted, useRefusal } from "../../state/accounts/accounts";
import { setLookUsed } from "../../state/actions";
import { indexColour } from "../../state/drawing/colours";
import { followedEdges } from "../../state/drawing/followed";
import { lookFacts, lookKey, lookTitle, refusedLooks } from "../../state/drawing/learnedLooks";
import { LINE_STYLES } from "../../state/drawing/palette";
import { useCustomerAnswers, useDrawing, useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { SHOW_EDGES } from "../shared/labels";
import panels from "../shared/panels.module.css";
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";
import css from "./learned.module.css";
import { previewHandlers } from "./previewHandlers";

export function TaughtPanel() {
  const { data: drawing } = useDrawing();
  const { data: edges } = useEdges();
  const permitted = useIsPermitted("PATCH /api/v1/drawings/{id}/customer-answers");
  const { data: answers } = useCustomerAnswers((drawing?.customer ?? "") !== "" && permitted);
  const followed = useMemo(() => (edges === undefined ? [] : followedEdges(edges)), [edges]);
  if (drawing === undefined) return null;
  const refused = refusedLooks(answers ?? []);
  if (drawing.learned.length + refused.length + followed.length === 0) return null;
  return (
    <Section
      title={
        <>
          <IconHistory size={15} color="var(--accent-ink)" aria-hidden />
          {translate("taughtPanel.decidedFromAnswers")}
        </>
      }
    >
      <div data-testid="taught">
        {drawing.learned.map((look) => (
          <Learned key={lookKey(look)} look={look} drawing={drawing} />
        ))}
        {followed.map(({ type, rows }) => (
          <article key={type} className={css.lesson} data-testid="followed">
            <Edges rows={rows} type={type}>
              {translateRich("taughtPanel.moreEdgesWithTheLook", {
                rows: rows.length,
                b: (children) => <b>{children}</b>,
              })}
            </Edges>
          </article>
        ))}
        {refused.map((look) => (
          <Refused key={lookKey(look)} look={look} />
        ))}
      </div>
    </Section>
  );
}

function Learned({ look, drawing }: { look: LearnedLook; drawing: Drawing }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/customer-answers");
  return (
    <article className={css.lesson} data-testid="learned-look">
      <Edges rows={look.edges} type={look.type}>
        <span
          className={panels.dot}
          style={{ display: "inline-block", background: indexColour(look.colour) }}
        />{" "}
        <b>{lookTitle(look)}</b>: {translate("taughtPanel.edges", { edges: look.edges.length })}
      </Edges>
      <p className={panels.note} style={{ margin: "4px 0 6px" }}>
        {translate("taughtPanel.learnedFromOf", {
          look: lookFacts(look),
          drawings: look.drawings.join(", "),
          customer: drawing.customer,
        })}
      </p>
      <button
        type="button"
        className={panels.link}
        style={{ margin: 0 }}
        disabled={busy || refusal !== null}
        title={refusal ?? translate("taughtPanel.askAboutSuchEdgesIn")}
        data-testid="take-back"
        onClick={() => void setLookUsed(look, false)}
      >
        {translate("taughtPanel.takeBackFor", { customer: drawing.customer })}
      </button>
    </article>
  );
}

function Refused({ look }: { look: TaughtLook }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/customer-answers");
  return (
    <p className={panels.note} style={{ margin: "6px 0 0" }} data-testid="refused-look">
      {translate("taughtPanel.noLongerDecidedAs", {
        look: lookTitle(look),
        look2: lookFacts(look),
        title: insideSentence(LINE_STYLES[look.type].title),
      })}{" "}
      <button
        type="button"
        className={panels.link}
        style={{ margin: 0 }}
        disabled={busy || refusal !== null}
        title={refusal ?? undefined}
        data-testid="use-again"
        onClick={() => void setLookUsed(look, true)}
      >
        {translate("taughtPanel.useAgain")}
      </button>
    </p>
  );
}

interface EdgesProps {
  rows: readonly number[];
  type: LearnedLook["type"];
  children: React.ReactNode;
}

/** A line about some edges that shows them when it is pressed. */
function Edges({ rows, type, children }: EdgesProps) {
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return (
    <button
      type="button"
      className={css.change}
      style={{ padding: 0, fontSize: 12.5, alignItems: "baseline" }}
      title={SHOW_EDGES}
      onClick={() => zoomToEdges(rows)}
      {...previewHandlers(() => [{ rows, type }])}
    >
      <Swatch type={type} />
      <span style={{ flex: 1, minWidth: 0, overflowWrap: "anywhere" }}>{children}</span>
      <span className={panels.rowFigure}>{LINE_STYLES[type].title}</span>
    </button>
  );
}
