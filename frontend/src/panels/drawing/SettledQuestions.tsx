/** What has been answered since the drawing was opened: a tick for the last answer, and for all. */

import { Group, Text } from "@mantine/core";
import { IconCircleCheckFilled } from "@tabler/icons-react";
import { useState } from "react";
import type { Question } from "../../api/drawings";
import { translate } from "../../language/translate";
import { edgeQuestionTitle } from "../../state/drawing/questions";
import { useUiStore } from "../../state/store";
import { Section } from "../shared/Section";

type Open = readonly (readonly [key: string, Question])[];

/** Identifies a question although some of its edges are answered alone. */
const keyOf = ({ kind, code, layer, colour }: Question): string =>
  [kind, code, layer, colour].join(" ");

const titleOf = (question: Question): string =>
  question.kind === "unit" ? translate("settledQuestions.unit") : edgeQuestionTitle(question);

interface Seen {
  readonly drawing: string | null;
  /** Titles of all questions by key. */
  readonly titles: ReadonlyMap<string, string>;
}

/** Titles of the questions that were open since the drawing was opened and are not any more. */
export function useSettled(open: Open): readonly string[] {
  const drawing = useUiStore((ui) => ui.drawing);
  const [seen, setSeen] = useState<Seen>({ drawing, titles: new Map() });
  const known = seen.drawing === drawing ? seen.titles : new Map<string, string>();
  const now = new Map(open.map(([, one]) => [keyOf(one), titleOf(one)]));
  if (seen.drawing !== drawing || [...now.keys()].some((key) => !known.has(key)))
    setSeen({ drawing, titles: new Map([...known, ...now]) });
  return [...known].filter(([key]) => !now.has(key)).map(([, title]) => title);
}

export function Settled({ count }: { count: number }) {
  return (
    <Group gap={7} fz={12} c="ink.2" role="status" wrap="nowrap" data-testid="settled">
      <IconCircleCheckFilled size={16} color="var(--good)" aria-hidden />
      <Text span>{translate("settledQuestions.answered", { count })}</Text>
    </Group>
  );
}

export function AllAnswered({ settled }: { settled: readonly string[] }) {
  return (
    <Section
      title={
        <>
          <IconCircleCheckFilled size={15} color="var(--good)" aria-hidden />
          {translate("settledQuestions.allAnswered")}
        </>
      }
    >
      <Text fz={12} c="ink.2" role="status" data-testid="all-answered">
        {settled.join(" · ")}
      </Text>
    </Section>
  );
}
