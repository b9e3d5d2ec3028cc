/** Rules learned from corrections, each previewed on the canvas before it is saved. */

import { Button, Stack, Text, TextInput } from "@mantine/core";
import { IconBulb } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import type { Proposal } from "../../api/drawings";
import type { Profile } from "../../api/library";
import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { messageText } from "../../messages/translateMessage";
import { useIsPermitted } from "../../state/accounts/accounts";
import { LINE_STYLES } from "../../state/drawing/palette";
import { saveLearnedRule } from "../../state/drawing/profiles";
import { useDrawing, useLearned, useProfiles } from "../../state/queries";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { ShowMore } from "../shared/ShowMore";
import { Swatch } from "../shared/Swatch";
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
          {translate("learnedPanel.rulesSuggestedFromTheLine")}
        </>
      }
    >
      <Stack gap={8} data-testid="learned">
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
      </Stack>
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
      className={panels.callout}
      data-tone="blue"
      data-testid="lesson"
      onMouseEnter={show}
      onMouseLeave={() => set({ retypePreviews: [] })}
      onFocus={show}
      onBlur={() => set({ retypePreviews: [] })}
    >
      <Text component="div" c="ink.0">
        {translateRich("learnedPanel.treatEveryEdgeThatMatches", {
          conditions: messageText(rule.conditions),
          type: insideSentence(LINE_STYLES[rule.type].title),
          b: (children) => <b>{children}</b>,
          line: (children) => (
            <span style={{ whiteSpace: "nowrap" }}>
              <Swatch type={rule.type} /> <b>{children}</b>
            </span>
          ),
        })}
      </Text>
      <Note mt={4}>
        {others === 0
          ? translate("learnedPanel.matchesEdgesThatYouSet", { explains: explains.length })
          : proposal.sure
            ? translate("learnedPanel.matchesEdgesThatYouSet2", { explains: explains.length })
            : translate("learnedPanel.matchesEdgesThatYouSet3", { explains: explains.length })}
      </Note>
      <TypeChanges changes={changes} />
      {profile.shipped ? (
        <form
          style={{ display: "flex", gap: 6 }}
          onSubmit={(event) => {
            event.preventDefault();
            void saveLearnedRule(proposal, profile, title.trim());
          }}
        >
          <TextInput
            size="xs"
            style={{ flex: 1 }}
            placeholder={translate("learnedPanel.newProfile")}
            aria-label={translate("learnedPanel.nameOfTheNewProfile")}
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
            {translate("learnedPanel.saveRule")}
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
          {translate("learnedPanel.addRuleToProfile", { title: profile.title })}
        </Button>
      )}
    </article>
  );
}
