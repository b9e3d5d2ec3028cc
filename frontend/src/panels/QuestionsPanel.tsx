/** Open questions, each answered with one click; a program needs the answers to all. */

import { IconHelpHexagonFilled } from "@tabler/icons-react";
import { useRef, useState } from "react";
import type { Question } from "../api/client";
import { useRefusal } from "../state/accounts";
import { retypeEach } from "../state/actions";
import { pluralize } from "../state/format";
import { LINE_STYLES } from "../state/palette";
import { useDrawing, useJob } from "../state/queries";
import { questionKey, suggestions } from "../state/questions";
import { type RetypePreview, useUiStore } from "../state/store";
import { EdgeQuestion } from "./EdgeQuestion";
import { Refusal } from "./Permitted";
import { previewHandlers } from "./previewHandlers";
import css from "./questions.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";
import { Swatch } from "./Swatch";
import { UnitQuestion } from "./UnitQuestion";

/** Questions listed at once. */
const STEP = 4;
/** With more questions, a button answers all at once. */
const FEW = 3;

export function QuestionsPanel() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const compileQuestions = useUiStore((ui) => ui.compileQuestions);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const [limit, setLimit] = useState(STEP);
  const list = useRef<HTMLDivElement>(null);
  if (drawing === undefined) return null;
  const questions = new Map<string, Question>();
  for (const question of [...drawing.questions, ...compileQuestions, ...(job?.questions ?? [])]) {
    questions.set(questionKey(question), question);
  }
  if (questions.size === 0) return null;
  const listed = [...questions];
  const lineTypeQuestions = listed
    .map(([, question]) => question)
    .filter(({ kind }) => kind === "line-type");
  const suggested = suggestions(lineTypeQuestions);
  const undecided = lineTypeQuestions.flatMap(({ edges }) => edges);
  // The next question is enabled one frame later.
  const focusNextAnswer = () =>
    requestAnimationFrame(() => list.current?.querySelector<HTMLElement>("[data-answer]")?.focus());
  return (
    <Section
      title={
        <>
          <IconHelpHexagonFilled size={15} color={LINE_STYLES.unclassified.colour} aria-hidden />
          {pluralize(questions.size, "open question")}
        </>
      }
    >
      <div ref={list} data-testid="questions">
        {listed
          .slice(0, limit)
          .map(([key, question]) =>
            question.kind === "unit" ? (
              <UnitQuestion key={key} question={question} drawing={drawing} />
            ) : (
              <EdgeQuestion key={key} question={question} onAnswered={focusNextAnswer} />
            ),
          )}
        <Refusal reason={refusal} />
        {listed.length > limit && (
          <ShowMore left={listed.length - limit} act={() => setLimit(limit + STEP)} />
        )}
        {suggested.length > 1 && (
          <SetMany
            retypings={suggested}
            title="One undo takes all of them back"
            figure={pluralize(suggested.length, "question")}
            name="accept-suggestions"
          >
            Accept all most likely line types
          </SetMany>
        )}
        {lineTypeQuestions.length > FEW && (
          <SetMany
            retypings={[{ rows: undecided, type: "ignored" }]}
            title="The edges stay visible in the drawing, but they are neither cut nor creased"
            figure={pluralize(undecided.length, "edge")}
            name="ignore-rest"
          >
            Set all undecided edges to ignored
          </SetMany>
        )}
      </div>
    </Section>
  );
}

/** Sets the line types of many edges; one undo takes all of them back. */
function SetMany({
  retypings,
  title,
  figure,
  name,
  children,
}: {
  retypings: readonly RetypePreview[];
  title: string;
  figure: string;
  name: string;
  children: string;
}) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  return (
    <button
      type="button"
      className={css.choice}
      style={{ width: "100%", marginTop: 8 }}
      disabled={busy || refusal !== null}
      title={title}
      data-testid={name}
      {...previewHandlers(() => retypings)}
      onClick={() => void retypeEach(retypings)}
    >
      <Swatch type={retypings[0]?.type ?? "unclassified"} />
      {children}
      <span className={css.choiceFigure}>{figure}</span>
    </button>
  );
}
