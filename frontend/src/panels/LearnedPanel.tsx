/** What corrections teach: rules for the customer, each shown in the picture before it is kept. */

import { Button, TextInput } from "@mantine/core";
import { IconBulb } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import type { Profile, Proposal } from "../api/client";
import { LINE_LOOKS } from "../state/palette";
import { keepLearned } from "../state/profiles";
import { useDrawing, useLearned, useProfiles } from "../state/queries";
import { usePage } from "../state/store";
import { count } from "../state/words";
import { Changes, proposedOf } from "./Changes";
import css from "./learned.module.css";
import panels from "./panels.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";
import { Swatch } from "./Swatch";

/** Lessons that come at once. */
const FEW = 3;

export function LearnedPanel() {
  const { data: drawing } = useDrawing();
  const { data: profiles } = useProfiles();
  const [most, setMost] = useState(FEW);
  const { data: learned } = useLearned((drawing?.overrides ?? 0) > 0);
  const profile = profiles?.find(({ name }) => name === drawing?.profile);
  if (drawing === undefined || drawing.overrides === 0 || profile === undefined) return null;
  if (learned === undefined || learned.length === 0) return null;
  return (
    <Section
      title={
        <>
          <IconBulb size={15} color="#79b2ff" aria-hidden />
          Learn from your corrections
        </>
      }
    >
      <div data-testid="learned">
        {learned.slice(0, most).map((proposal) => (
          <Lesson
            key={`${proposal.rule.type} ${proposal.rule.words}`}
            proposal={proposal}
            profile={profile}
          />
        ))}
        {learned.length > most && (
          <ShowMore left={learned.length - most} act={() => setMost(learned.length)} />
        )}
      </div>
    </Section>
  );
}

function Lesson({ proposal, profile }: { proposal: Proposal; profile: Profile }) {
  const busy = usePage((page) => page.busy);
  const set = usePage((page) => page.set);
  const [title, setTitle] = useState("");
  const { rule, changes, explains } = proposal;
  const others = changes.reduce((sum, { edges }) => sum + edges.length, 0);
  useEffect(() => () => set({ proposed: [] }), [set]);
  const show = () =>
    set({ proposed: [{ rows: explains, type: rule.type }, ...proposedOf(changes)] });
  return (
    <article
      className={css.lesson}
      data-testid="lesson"
      onMouseEnter={show}
      onMouseLeave={() => set({ proposed: [] })}
      onFocus={show}
      onBlur={() => set({ proposed: [] })}
    >
      <div className={css.lessonHead}>
        Always take <b>{rule.words}</b> as{" "}
        <span style={{ whiteSpace: "nowrap" }}>
          <Swatch type={rule.type} />
          <b>{LINE_LOOKS[rule.type].title.toLowerCase()}</b>
        </span>
      </div>
      <p className={panels.note} style={{ margin: "4px 0 0" }}>
        It says what you said of {count(explains.length, "edge")}
        {others === 0
          ? ", and changes no other."
          : proposal.sure
            ? ", and decides others that are open:"
            : ", and would also change others:"}
      </p>
      <Changes changes={changes} />
      {profile.shipped ? (
        <form
          className={css.save}
          onSubmit={(event) => {
            event.preventDefault();
            void keepLearned(proposal, profile, title.trim());
          }}
        >
          <TextInput
            size="xs"
            style={{ flex: 1 }}
            placeholder="Name of the customer"
            aria-label="Name of the customer"
            maxLength={120}
            value={title}
            data-testid="customer"
            onChange={(event) => setTitle(event.currentTarget.value)}
          />
          <Button
            type="submit"
            size="xs"
            disabled={busy || title.trim() === ""}
            data-testid="keep-lesson"
          >
            Keep
          </Button>
        </form>
      ) : (
        <Button
          size="xs"
          fullWidth
          disabled={busy}
          data-testid="keep-lesson"
          onClick={() => void keepLearned(proposal, profile, profile.title)}
        >
          Keep for {profile.title}
        </Button>
      )}
    </article>
  );
}
