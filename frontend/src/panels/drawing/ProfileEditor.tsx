/** Editor for a line-type profile; counts the edges that each rule matches in the open drawing. */

import {
  ActionIcon,
  Box,
  Button,
  Flex,
  Group,
  Select,
  Skeleton,
  Switch,
  TextInput,
  Title,
  Tooltip,
} from "@mantine/core";
import { IconArrowLeft, IconPlus } from "@tabler/icons-react";
import { type ReactNode, useEffect, useState } from "react";
import type { Preview } from "../../api/drawings";
import type { Profile } from "../../api/library";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import {
  addRule,
  type Draft,
  moveRule,
  newRule,
  removeRule,
  updateRule,
} from "../../state/drawing/draft";
import { type PreviewState, usePreview } from "../../state/drawing/preview";
import { useProfileDraft, versionKey } from "../../state/drawing/profileDraft";
import { saveDraft, showSaved, unusedName } from "../../state/drawing/profiles";
import { useDrawing, useProfiles } from "../../state/queries";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { InheritedRules } from "./InheritedRules";
import { ProfileFiles } from "./ProfileFiles";
import css from "./profile.module.css";
import { RuleCard } from "./RuleCard";
import { previewsOfChanges, TypeChanges } from "./TypeChanges";

const BACK = translate("profileEditor.backToTheDrawing");

export function ProfileEditor({ name }: { name: string }) {
  const { data: profiles } = useProfiles();
  const profile = profiles?.find((one) => one.name === name);
  if (profiles === undefined) return <Skeleton height={200} m={16} />;
  if (profile === undefined) return <MissingProfile />;
  return <LoadedProfile profile={profile} profiles={profiles} />;
}

/** Starts a draft of the profile; another version of it gets another draft. */
function LoadedProfile({ profile, profiles }: Props) {
  const { version, draft, begin } = useProfileDraft();
  useEffect(() => begin(profile), [begin, profile]);
  if (draft === null || version !== versionKey(profile)) return null;
  return <Editor key={version} profile={profile} profiles={profiles} draft={draft} />;
}

function MissingProfile() {
  const set = useUiStore((ui) => ui.set);
  return (
    <Box p={16}>
      <Note>{translate("profileEditor.thisProfileWasDeletedAnd")}</Note>
      <Button size="xs" variant="default" onClick={() => set({ editedProfile: null })}>
        {BACK}
      </Button>
    </Box>
  );
}

interface Props {
  profile: Profile;
  profiles: readonly Profile[];
}

function Editor({ profile, profiles, draft }: Props & { draft: Draft }) {
  const { data: drawing } = useDrawing();
  const discardDraft = useProfileDraft((editor) => editor.discard);
  const touched = useProfileDraft(({ past }) => past.length > 0);
  const busy = useUiStore((ui) => ui.busy);
  const set = useUiStore((ui) => ui.set);
  const preview = usePreview(drawing?.id ?? null, draft);
  const changes = preview.data?.changes ?? [];
  const inheritedRules = preview.data?.rules.filter(({ inherited }) => inherited) ?? [];
  const untitled = draft.title.trim() === "";

  useEffect(() => {
    set({ retypePreviews: previewsOfChanges(changes) });
    return () => set({ retypePreviews: [] });
  }, [changes, set]);

  const close = () => set({ editedProfile: null, retypePreviews: [] });
  const discard = () => {
    discardDraft();
    close();
  };
  const save = async () => {
    const taken = profiles.map((one) => one.name);
    const target = profile.shipped ? unusedName(draft.title, taken) : profile.name;
    if (await saveDraft(target, draft)) showSaved(target, profile.name);
  };
  const inherited = draft.extends !== null && (
    <InheritedRules
      title={profiles.find(({ name }) => name === draft.extends)?.title ?? draft.extends}
      rules={preview.data === null ? null : inheritedRules}
    />
  );
  return (
    <div className={css.editor} data-testid="profile-editor">
      <Group gap={8} ml={-6} wrap="nowrap">
        <Tooltip
          label={
            touched ? translate("profileEditor.yourUnsavedEditsAreKept", { back: BACK }) : BACK
          }
        >
          <ActionIcon variant="subtle" color="gray" aria-label={BACK} onClick={close}>
            <IconArrowLeft size={17} />
          </ActionIcon>
        </Tooltip>
        <Title order={1} flex={1} fz={15} fw={600}>
          {profile.shipped ? translate("profileEditor.newProfile") : profile.title}
        </Title>
        <ProfileFiles profile={profile} />
      </Group>
      {profile.fault !== "" && (
        <p className={panels.callout} data-tone="red">
          {profile.fault}
        </p>
      )}
      <ProfileFields draft={draft} profiles={profiles} />
      <RuleList draft={draft} preview={preview.data} inherited={inherited} />
      <div className={css.outcome}>
        <PreviewResult preview={preview} />
        <Group gap={8} mt={10}>
          <Button
            size="xs"
            disabled={busy || untitled || !touched || preview.error !== null}
            onClick={() => void save()}
            data-testid="save-profile"
          >
            {translate("profileEditor.saveAndApplyToDrawing")}
          </Button>
          <Button size="xs" variant="default" onClick={discard}>
            {touched
              ? translate("profileEditor.discardEdits")
              : translate("profileEditor.closeEditor")}
          </Button>
        </Group>
      </div>
    </div>
  );
}

/** Title of the profile and the profile that it extends. */
function ProfileFields({ draft, profiles }: { draft: Draft; profiles: readonly Profile[] }) {
  const edit = useProfileDraft((editor) => editor.edit);
  return (
    <>
      <TextInput
        size="xs"
        label={translate("profileEditor.nameOfTheProfile")}
        placeholder={translate("profileEditor.eGNameOfThe")}
        maxLength={120}
        value={draft.title}
        data-testid="profile-title"
        onChange={(event) => edit({ ...draft, title: event.currentTarget.value }, "title")}
      />
      <Select
        size="xs"
        label={translate("profileEditor.builtInProfileWhoseRules")}
        clearable
        placeholder={translate("profileEditor.noneOnlyTheRulesBelow")}
        data={profiles
          .filter(({ shipped }) => shipped)
          .map((one) => ({ value: one.name, label: one.title }))}
        value={draft.extends}
        onChange={(value) => edit({ ...draft, extends: value })}
      />
      {draft.extends !== null && (
        <Switch
          size="xs"
          label={translate("profileEditor.applyTheRulesBelowBefore")}
          checked={draft.overrules}
          onChange={(event) => edit({ ...draft, overrules: event.currentTarget.checked })}
        />
      )}
    </>
  );
}

interface RuleListProps {
  draft: Draft;
  preview: Preview | null;
  /** Shown before or after the rules of the profile. */
  inherited: ReactNode;
}

function RuleList({ draft, preview, inherited }: RuleListProps) {
  const edit = useProfileDraft((editor) => editor.edit);
  const [dragged, setDragged] = useState<number | null>(null);
  const own = preview?.rules.filter((rule) => !rule.inherited) ?? [];
  return (
    <>
      <Group gap={8} mt={4} justify="space-between" wrap="nowrap" fz={12} fw={600} c="ink.2">
        <span>{translate("profileEditor.rulesTheFirstRuleThat")}</span>
        <Button
          size="compact-xs"
          variant="default"
          leftSection={<IconPlus size={13} />}
          data-testid="add-rule"
          onClick={() => edit(addRule(draft, newRule({ type: "cut" })))}
        >
          {translate("profileEditor.addRule")}
        </Button>
      </Group>
      {!draft.overrules && inherited}
      <Flex component="ol" direction="column" gap={8} data-testid="rules">
        {draft.rules.map((rule, at) => (
          <RuleCard
            key={rule.key}
            rule={rule}
            number={at + 1}
            edges={own[at]?.edges ?? null}
            lifted={dragged === rule.key}
            onChange={(part) =>
              edit(updateRule(draft, rule.key, part), `${rule.key} ${Object.keys(part)}`)
            }
            onDelete={() => edit(removeRule(draft, rule.key))}
            onMove={(to) => edit(moveRule(draft, rule.key, to))}
            onLift={setDragged}
            onOver={() => {
              if (dragged !== null && dragged !== rule.key)
                edit(moveRule(draft, dragged, at), `dragged-${dragged}`);
            }}
          />
        ))}
      </Flex>
      {draft.rules.length === 0 && <Note>{translate("profileEditor.thisProfileHasNoRules")}</Note>}
      {draft.overrules && inherited}
    </>
  );
}

/** What the draft would change in the open drawing, or why it is invalid. */
function PreviewResult({ preview }: { preview: PreviewState }) {
  const { data: drawing } = useDrawing();
  if (preview.error !== null) {
    return (
      <p className={panels.callout} data-tone="red" role="alert" data-testid="profile-fault">
        {errorText(preview.error)}
      </p>
    );
  }
  if (preview.data === null) return null;
  const { changes, open } = preview.data;
  const changed = changes.reduce((sum, { edges }) => sum + edges.length, 0);
  return (
    <>
      <Note data-testid="profile-outcome">
        {translate("profileEditor.outcome", { changed, open })}
        {(drawing?.overrides ?? 0) > 0 && ` ${translate("profileEditor.edgesSetByHandKeep")}`}
      </Note>
      <TypeChanges changes={changes} />
    </>
  );
}
