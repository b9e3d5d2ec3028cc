/** Rules learned from corrections, each previewed on the canvas before it is saved. */

import { Button, TextInput } from "@mantine/core";
import { IconBulb } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import type { Profile, Proposal } from "../api/client";
import { renderText } from "../messages/render";
import { useIsPermitted } from "../state/accounts";
import { pluralize } from "../state/format";
import { LINE_STYLES } from "../state/palette";
import { saveLearnedRule } from "../state/profiles";
import { useDrawing, useLearned, useProfiles } from "../state/queries";
import { useUiStore } from "../state/store";
import css from "./learned.module.css";
import panels from "./panels.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";
import { Swatch } from "./Swatch";
import { previewsOfChanges, TypeChanges } from "./TypeChanges";

/** Rules listed at once. */
const FEW = 3;

export function LearnedPanel() {
  const { data: drawing } = useDrawing();
  const { data: profiles } = useProfiles();
  const [limit, setLimit] = useState(FEW);
  const permitted = useIsPermitted("POST /api/v1/drawings/{id}/learned");
  const { data: learned } = useLearned((drawing?.overrides ?? 0) > 0 && permitted);
  const profile = profiles?.find(({ name }) => name === drawing?.profile);
  if (drawing === undefined || drawing.overrides === 0 || profile === undefined) return null;
  if (learned === undefined || learned.length === 0) return null;
  return (
    <Section
      title={
        <>
          <IconBulb size={15} color="var(--accent-ink)" aria-hidden />
          Rules suggested from the line types that you set
        </>
      }
    >
      <div data-testid="learned">
        {learned.slice(0, limit).map((proposal) => (
          <LearnedRule
            key={`${proposal.rule.type} ${proposal.rule.conditions.text}`}
            proposal={proposal}
            profile={profile}
          />
        ))}
        {learned.length > limit && (
          <ShowMore left={learned.length - limit} act={() => setLimit(learned.length)} />
        )}
      </div>
    </Section>
  );
}

function LearnedRule({ proposal, profile }: { proposal: Proposal; profile: Profile }) {
  const busy = useUiStore((ui) => ui.busy);
  const set = useUiStore((ui) => ui.set);
  const [title, setTitle] = useState("");
  const { rule, changes, explains } = proposal;
  const others = changes.reduce((sum, { edges }) => sum + edges.length, 0);
  useEffect(() => () => set({ retypePreviews: [] }), [set]);
  const show = () =>
    set({ retypePreviews: [{ rows: explains, type: rule.type }, ...previewsOfChanges(changes)] });
  return (
    <article
      className={css.lesson}
      data-testid="lesson"
      onMouseEnter={show}
      onMouseLeave={() => set({ retypePreviews: [] })}
      onFocus={show}
      onBlur={() => set({ retypePreviews: [] })}
    >
      <div className={css.lessonHead}>
        Treat every edge that matches <b>{renderText(rule.conditions)}</b> as{" "}
        <span style={{ whiteSpace: "nowrap" }}>
          <Swatch type={rule.type} />
          <b>{LINE_STYLES[rule.type].title.toLowerCase()}</b>
        </span>
      </div>
      <p className={panels.note} style={{ margin: "4px 0 0" }}>
        Matches {pluralize(explains.length, "edge")} that you set by hand
        {others === 0
          ? ". No other edge changes."
          : proposal.sure
            ? ". Also sets the line type of edges that have none:"
            : ". Also changes the line type of other edges:"}
      </p>
      <TypeChanges changes={changes} />
      {profile.shipped ? (
        <form
          className={css.save}
          onSubmit={(event) => {
            event.preventDefault();
            void saveLearnedRule(proposal, profile, title.trim());
          }}
        >
          <TextInput
            size="xs"
            style={{ flex: 1 }}
            placeholder="New profile"
            aria-label="Name of the new profile"
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
            Save rule
          </Button>
        </form>
      ) : (
        <Button
          size="xs"
          fullWidth
          disabled={busy}
          data-testid="keep-lesson"
          onClick={() => void saveLearnedRule(proposal, profile, profile.title)}
        >
          Add rule to profile {profile.title}
        </Button>
      )}
    </article>
  );
}
