/** Editor for a line-type profile; counts the edges that each rule matches in the open drawing. */

import { ActionIcon, Button, Select, Skeleton, Switch, TextInput, Tooltip } from "@mantine/core";
import { IconArrowLeft, IconDownload, IconPlus, IconTrash, IconUpload } from "@tabler/icons-react";
import { useEffect, useRef, useState } from "react";
import { type Preview, type Profile, service } from "../api/client";
import { errorText } from "../messages/render";
import { addRule, type Draft, moveRule, newRule, removeRule, updateRule } from "../state/draft";
import { pluralize } from "../state/format";
import { usePreview } from "../state/preview";
import { useProfileDraft, versionKey } from "../state/profileDraft";
import { deleteProfile, importProfile, saveDraft, unusedName } from "../state/profiles";
import { useDrawing, useProfiles } from "../state/queries";
import { useUiStore } from "../state/store";
import panels from "./panels.module.css";
import css from "./profile.module.css";
import { RuleCard } from "./RuleCard";
import { RuleSummary } from "./RuleSummary";
import { previewsOfChanges, TypeChanges } from "./TypeChanges";

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
    <div style={{ padding: 16 }}>
      <p className={panels.note}>This profile was deleted.</p>
      <Button size="xs" variant="default" onClick={() => set({ editedProfile: null })}>
        Back
      </Button>
    </div>
  );
}

interface Props {
  profile: Profile;
  profiles: readonly Profile[];
}

function Editor({ profile, profiles, draft }: Props & { draft: Draft }) {
  const { data: drawing } = useDrawing();
  const { edit, discard: discardDraft } = useProfileDraft();
  const touched = useProfileDraft(({ past }) => past.length > 0);
  const busy = useUiStore((ui) => ui.busy);
  const set = useUiStore((ui) => ui.set);
  const [dragged, setDragged] = useState<number | null>(null);
  const preview = usePreview(drawing?.id ?? null, draft);
  const changes = preview.data?.changes ?? [];
  const own = preview.data?.rules.filter(({ inherited }) => !inherited) ?? [];
  const theirs = preview.data?.rules.filter(({ inherited }) => inherited) ?? [];
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
    const under = profile.shipped ? unusedName(draft.title, taken) : profile.name;
    if (await saveDraft(under, draft)) set({ editedProfile: under });
  };
  const inherited = draft.extends !== null && (
    <Inherited
      title={profiles.find(({ name }) => name === draft.extends)?.title ?? draft.extends}
      rules={preview.data === null ? null : theirs}
    />
  );
  return (
    <div className={css.editor} data-testid="profile-editor">
      <div className={css.head}>
        <Tooltip label={touched ? "Back to drawing (keeps your edits)" : "Back to drawing"}>
          <ActionIcon variant="subtle" color="gray" aria-label="Back" onClick={close}>
            <IconArrowLeft size={17} />
          </ActionIcon>
        </Tooltip>
        <h2 className={panels.docName} style={{ margin: 0, flex: 1 }}>
          {profile.shipped ? "New profile" : profile.title}
        </h2>
        <Files profile={profile} />
      </div>
      {profile.fault !== "" && <p className={css.fault}>{profile.fault}</p>}
      <TextInput
        size="xs"
        label="Customer"
        placeholder="Customer name"
        maxLength={120}
        value={draft.title}
        data-testid="profile-title"
        onChange={(event) => edit({ ...draft, title: event.currentTarget.value }, "title")}
      />
      <Select
        size="xs"
        label="Based on"
        clearable
        placeholder="Nothing: only the rules below"
        data={profiles
          .filter(({ shipped }) => shipped)
          .map((one) => ({ value: one.name, label: one.title }))}
        value={draft.extends}
        onChange={(value) => edit({ ...draft, extends: value })}
      />
      {draft.extends !== null && (
        <Switch
          size="xs"
          label="Own rules first"
          checked={draft.overrules}
          onChange={(event) => edit({ ...draft, overrules: event.currentTarget.checked })}
        />
      )}
      <div className={css.rulesHead}>
        <span>Rules (first match wins)</span>
        <Button
          size="compact-xs"
          variant="default"
          leftSection={<IconPlus size={13} />}
          data-testid="add-rule"
          onClick={() => edit(addRule(draft, newRule({ type: "cut" })))}
        >
          Add rule
        </Button>
      </div>
      {!draft.overrules && inherited}
      <ol className={css.rules} data-testid="rules">
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
                edit(moveRule(draft, dragged, at), `dragged ${dragged}`);
            }}
          />
        ))}
      </ol>
      {draft.rules.length === 0 && (
        <p className={panels.note} style={{ margin: 0 }}>
          No rules yet. Add one, or set edges by hand and save a learned rule.
        </p>
      )}
      {draft.overrules && inherited}
      <div className={css.outcome}>
        {preview.error !== null ? (
          <p className={css.fault} role="alert" data-testid="profile-fault">
            {errorText(preview.error)}
          </p>
        ) : (
          preview.data && (
            <>
              <p className={panels.note} style={{ margin: 0 }} data-testid="profile-outcome">
                {changes.length === 0
                  ? "No change in this drawing"
                  : `${pluralize(
                      changes.reduce((sum, { edges }) => sum + edges.length, 0),
                      "edge",
                    )} change in this drawing`}
                {preview.data.open > 0 && `; ${pluralize(preview.data.open, "edge")} match no rule`}
                .{(drawing?.overrides ?? 0) > 0 && " Edges set by hand keep their type."}
              </p>
              <TypeChanges changes={changes} />
            </>
          )
        )}
        <div className={css.buttons}>
          <Button
            size="xs"
            disabled={busy || untitled || !touched || preview.error !== null}
            onClick={() => void save()}
            data-testid="save-profile"
          >
            Save and apply
          </Button>
          <Button size="xs" variant="default" onClick={discard}>
            {touched ? "Discard" : "Close"}
          </Button>
        </div>
      </div>
    </div>
  );
}

interface InheritedProps {
  title: string;
  /** null until the server has counted their edges */
  rules: Preview["rules"] | null;
}

function Inherited({ title, rules }: InheritedProps) {
  const [open, setOpen] = useState(false);
  const edges = rules?.reduce((sum, rule) => sum + rule.edges, 0) ?? 0;
  return (
    <div className={css.inherited}>
      <button
        type="button"
        className={css.inheritedHead}
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      >
        <span>{title}</span>
        <span className={panels.rowFigure}>
          {rules === null
            ? "…"
            : `${pluralize(rules.length, "rule")} · ${pluralize(edges, "edge")}`}
        </span>
      </button>
      {open &&
        rules?.map((rule, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a profile may have two rules alike
          <RuleSummary key={`${at} ${rule.words}`} rule={rule} />
        ))}
    </div>
  );
}

/** Export, import and delete. */
function Files({ profile }: { profile: Profile }) {
  const input = useRef<HTMLInputElement>(null);
  const set = useUiStore((ui) => ui.set);
  return (
    <span style={{ display: "flex" }}>
      <Tooltip label="Export TOML">
        <ActionIcon
          component="a"
          href={service.profileUrl(profile.name)}
          download={`${profile.name}.toml`}
          variant="subtle"
          color="gray"
          aria-label="Export TOML"
          data-testid="export-profile"
        >
          <IconDownload size={16} />
        </ActionIcon>
      </Tooltip>
      <Tooltip label="Import TOML">
        <ActionIcon
          variant="subtle"
          color="gray"
          aria-label="Import TOML"
          onClick={() => input.current?.click()}
        >
          <IconUpload size={16} />
        </ActionIcon>
      </Tooltip>
      <input
        ref={input}
        type="file"
        accept=".toml"
        hidden
        data-testid="import-profile"
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          event.currentTarget.value = "";
          if (file !== undefined)
            void importProfile(file).then((name) => name !== null && set({ editedProfile: name }));
        }}
      />
      {!profile.shipped && (
        <Tooltip label="Delete profile">
          <ActionIcon
            variant="subtle"
            color="gray"
            aria-label="Delete profile"
            data-testid="delete-profile"
            onClick={() => {
              set({ editedProfile: null });
              void deleteProfile(profile);
            }}
          >
            <IconTrash size={16} />
          </ActionIcon>
        </Tooltip>
      )}
    </span>
  );
}
