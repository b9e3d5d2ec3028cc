/** Edges that earlier drawings of the customer, or other answers in this drawing, have decided. */

import { Stack, Text } from "@mantine/core";
import { IconHistory } from "@tabler/icons-react";
import { useMemo } from "react";
import type { Drawing, LearnedLook, TaughtLook } from "../../api/drawings";
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
import { Figure, LinkButton, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";
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
      <Stack gap={8} data-testid="taught">
        {drawing.learned.map((look) => (
          <Learned key={lookKey(look)} look={look} drawing={drawing} />
        ))}
        {followed.map(({ type, rows }) => (
          <article key={type} className={panels.callout} data-tone="blue" data-testid="followed">
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
      </Stack>
    </Section>
  );
}

function Learned({ look, drawing }: { look: LearnedLook; drawing: Drawing }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/customer-answers");
  return (
    <article className={panels.callout} data-tone="blue" data-testid="learned-look">
      <Edges rows={look.edges} type={look.type}>
        <span
          className={panels.dot}
          style={{ display: "inline-block", background: indexColour(look.colour) }}
        />{" "}
        <b>{lookTitle(look)}</b>: {translate("taughtPanel.edges", { edges: look.edges.length })}
      </Edges>
      <Note mt={4} mb={6}>
        {translate("taughtPanel.learnedFromOf", {
          look: lookFacts(look),
          drawings: look.drawings.join(", "),
          customer: drawing.customer,
        })}
      </Note>
      <LinkButton
        type="button"
        disabled={busy || refusal !== null}
        title={refusal ?? translate("taughtPanel.askAboutSuchEdgesIn")}
        data-testid="take-back"
        onClick={() => void setLookUsed(look, false)}
      >
        {translate("taughtPanel.takeBackFor", { customer: drawing.customer })}
      </LinkButton>
    </article>
  );
}

function Refused({ look }: { look: TaughtLook }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/customer-answers");
  return (
    <Note mt={6} data-testid="refused-look">
      {translate("taughtPanel.noLongerDecidedAs", {
        look: lookTitle(look),
        look2: lookFacts(look),
        title: insideSentence(LINE_STYLES[look.type].title),
      })}{" "}
      <LinkButton
        type="button"
        disabled={busy || refusal !== null}
        title={refusal ?? undefined}
        data-testid="use-again"
        onClick={() => void setLookUsed(look, true)}
      >
        {translate("taughtPanel.useAgain")}
      </LinkButton>
    </Note>
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
      className={panels.pick}
      title={SHOW_EDGES}
      onClick={() => zoomToEdges(rows)}
      {...previewHandlers(() => [{ rows, type }])}
    >
      <Swatch type={type} />
      <Text span flex={1} miw={0}>
        {children}
      </Text>
      <Figure>{LINE_STYLES[type].title}</Figure>
    </button>
  );
}
