/** What somebody must decide before anything is cut; each in one click. */

import { IconHelpHexagonFilled } from "@tabler/icons-react";
import { useRef, useState } from "react";
import type { Question } from "../api/client";
import { retype } from "../state/actions";
import { LINE_LOOKS } from "../state/palette";
import { useDrawing, useJob } from "../state/queries";
import { usePage } from "../state/store";
import { count } from "../state/words";
import { EdgeQuestion } from "./EdgeQuestion";
import { showing } from "./pointing";
import css from "./questions.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";
import { Swatch } from "./Swatch";
import { UnitQuestion } from "./UnitQuestion";

/** Questions that come at once: one that is answered makes room for the next. */
const STEP = 4;
/** Up to so many, each is answered by itself. */
const FEW = 3;

export function QuestionsPanel() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const asked = usePage((page) => page.asked);
  const [most, setMost] = useState(STEP);
  const list = useRef<HTMLDivElement>(null);
  if (drawing === undefined) return null;
  const questions = new Map<string, Question>();
  for (const question of [...drawing.questions, ...asked, ...(job?.questions ?? [])]) {
    questions.set(question.text, question);
  }
  if (questions.size === 0) return null;
  const listed = [...questions];
  const lines = listed.map(([, question]) => question).filter(({ kind }) => kind === "line-type");
  // A frame later it can be answered.
  const toNext = () =>
    requestAnimationFrame(() => list.current?.querySelector<HTMLElement>("[data-answer]")?.focus());
  return (
    <Section
      title={
        <>
          <IconHelpHexagonFilled size={15} color={LINE_LOOKS.unclassified.colour} aria-hidden />
          {count(questions.size, "open question")}
        </>
      }
    >
      <div ref={list} data-testid="questions">
        {listed
          .slice(0, most)
          .map(([text, question]) =>
            question.kind === "unit" ? (
              <UnitQuestion key={text} question={question} drawing={drawing} />
            ) : (
              <EdgeQuestion key={text} question={question} onAnswered={toNext} />
            ),
          )}
        {listed.length > most && (
          <ShowMore left={listed.length - most} act={() => setMost(most + STEP)} />
        )}
        {lines.length > FEW && <TheRest questions={lines} />}
      </div>
    </Section>
  );
}

/** One answer to all: much of a messy sheet is of no concern to the machine. */
function TheRest({ questions }: { questions: readonly Question[] }) {
  const busy = usePage((page) => page.busy);
  const rows = questions.flatMap(({ edges }) => edges);
  return (
    <button
      type="button"
      className={css.choice}
      style={{ width: "100%", marginTop: 8 }}
      disabled={busy}
      title="They are shown, and kept out of the tool path"
      data-testid="ignore-rest"
      {...showing(() => [{ rows, type: "ignored" }])}
      onClick={() => void retype(rows, "ignored")}
    >
      <Swatch type="ignored" />
      Ignore all that is open
      <span className={css.choiceFigure}>{count(rows.length, "edge")}</span>
    </button>
  );
}
