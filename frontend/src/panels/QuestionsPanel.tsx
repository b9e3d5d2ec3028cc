/** Open questions, each answered with one click; a program needs the answers to all. */

import { IconHelpHexagonFilled } from "@tabler/icons-react";
import { useRef, useState } from "react";
import type { Question } from "../api/client";
import { useRefusal } from "../state/accounts";
import { retype, retypeEach } from "../state/actions";
import { pluralize } from "../state/format";
import { LINE_STYLES } from "../state/palette";
import { useDrawing, useJob } from "../state/queries";
import { questionKey, suggestions } from "../state/questions";
import { useUiStore } from "../state/store";
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
        <AcceptSuggestions questions={lineTypeQuestions} />
        {lineTypeQuestions.length > FEW && <IgnoreAll questions={lineTypeQuestions} />}
      </div>
    </Section>
  );
}

/** Gives the edges of each question with a most likely line type this line type. */
function AcceptSuggestions({ questions }: { questions: readonly Question[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const suggested = suggestions(questions);
  if (suggested.length < 2) return null;
  return (
    <button
      type="button"
      className={css.choice}
      style={{ width: "100%", marginTop: 8 }}
      disabled={busy || refusal !== null}
      title="One undo takes all of them back"
      data-testid="accept-suggestions"
      {...previewHandlers(() => suggested)}
      onClick={() => void retypeEach(suggested)}
    >
      <Swatch type={suggested[0]?.type ?? "unclassified"} />
      Accept all most likely line types
      <span className={css.choiceFigure}>{pluralize(suggested.length, "question")}</span>
    </button>
  );
}

/** Sets the edges of all questions to ignored. */
function IgnoreAll({ questions }: { questions: readonly Question[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const rows = questions.flatMap(({ edges }) => edges);
  return (
    <button
      type="button"
      className={css.choice}
      style={{ width: "100%", marginTop: 8 }}
      disabled={busy || refusal !== null}
      title="The edges stay visible in the drawing, but they are neither cut nor creased"
      data-testid="ignore-rest"
      {...previewHandlers(() => [{ rows, type: "ignored" }])}
      onClick={() => void retype(rows, "ignored")}
    >
      <Swatch type="ignored" />
      Set all undecided edges to ignored
      <span className={css.choiceFigure}>{pluralize(rows.length, "edge")}</span>
    </button>
  );
}
