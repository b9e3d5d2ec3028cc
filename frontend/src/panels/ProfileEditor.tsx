/** A profile, rule by rule: what each takes of the drawing that is open is counted as one types. */

import { ActionIcon, Button, Select, Skeleton, Switch, TextInput, Tooltip } from "@mantine/core";
import { IconArrowLeft, IconDownload, IconPlus, IconTrash, IconUpload } from "@tabler/icons-react";
import { useEffect, useRef, useState } from "react";
import { type Preview, type Profile, service } from "../api/client";
import {
  type Draft,
  draftRule,
  withChanged,
  withMoved,
  withoutRule,
  withRule,
} from "../state/draft";
import { useEditing, versionOf } from "../state/editing";
import { usePreview } from "../state/preview";
import { forgetProfile, freeName, importProfile, keepDraft } from "../state/profiles";
import { useDrawing, useProfiles } from "../state/queries";
import { usePage } from "../state/store";
import { count } from "../state/words";
import { Changes, proposedOf } from "./Changes";
import panels from "./panels.module.css";
import css from "./profile.module.css";
import { RuleCard } from "./RuleCard";
import { RuleWords } from "./RuleWords";

export function ProfileEditor({ name }: { name: string }) {
  const { data: profiles } = useProfiles();
  const profile = profiles?.find((one) => one.name === name);
  if (profiles === undefined) return <Skeleton height={200} m={16} />;
  if (profile === undefined) return <Gone />;
  return <Begun profile={profile} profiles={profiles} />;
}

/** Another version is another thing to edit. */
function Begun({ profile, profiles }: Props) {
  const { of, now, begin } = useEditing();
  useEffect(() => begin(profile), [begin, profile]);
  if (now === null || of !== versionOf(profile)) return null;
  return <Editor key={of} profile={profile} profiles={profiles} draft={now} />;
}

function Gone() {
  const set = usePage((page) => page.set);
  return (
    <div style={{ padding: 16 }}>
      <p className={panels.note}>This profile is not kept any more.</p>
      <Button size="xs" variant="default" onClick={() => set({ editing: null })}>
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
  const { edit, forget } = useEditing();
  const touched = useEditing(({ past }) => past.length > 0);
  const busy = usePage((page) => page.busy);
  const set = usePage((page) => page.set);
  const [dragged, setDragged] = useState<number | null>(null);
  const preview = usePreview(drawing?.id ?? null, draft);
  const changes = preview.data?.changes ?? [];
  const own = preview.data?.rules.filter(({ inherited }) => !inherited) ?? [];
  const theirs = preview.data?.rules.filter(({ inherited }) => inherited) ?? [];
  const untitled = draft.title.trim() === "";

  useEffect(() => {
    set({ proposed: proposedOf(changes) });
    return () => set({ proposed: [] });
  }, [changes, set]);

  const close = () => set({ editing: null, proposed: [] });
  const discard = () => {
    forget();
    close();
  };
  const save = async () => {
    const taken = profiles.map((one) => one.name);
    const under = profile.shipped ? freeName(draft.title, taken) : profile.name;
    if (await keepDraft(under, draft)) set({ editing: under });
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
        <Tooltip
          label={touched ? "Back to the drawing; your edits wait here" : "Back to the drawing"}
        >
          <ActionIcon variant="subtle" color="gray" aria-label="Back" onClick={close}>
            <IconArrowLeft size={17} />
          </ActionIcon>
        </Tooltip>
        <h2 className={panels.docName} style={{ margin: 0, flex: 1 }}>
          {profile.shipped ? "New customer's profile" : profile.title}
        </h2>
        <Files profile={profile} />
      </div>
      {profile.fault !== "" && <p className={css.fault}>{profile.fault}</p>}
      <TextInput
        size="xs"
        label="Customer"
        placeholder="Whose drawings are these?"
        maxLength={120}
        value={draft.title}
        data-testid="profile-title"
        onChange={(event) => edit({ ...draft, title: event.currentTarget.value }, "title")}
      />
      <Select
        size="xs"
        label="On top of"
        clearable
        placeholder="nothing: only the rules below"
        data={profiles
          .filter(({ shipped }) => shipped)
          .map((one) => ({ value: one.name, label: one.title }))}
        value={draft.extends}
        onChange={(value) => edit({ ...draft, extends: value })}
      />
      {draft.extends !== null && (
        <Switch
          size="xs"
          label="The customer's rules come first"
          checked={draft.overrules}
          onChange={(event) => edit({ ...draft, overrules: event.currentTarget.checked })}
        />
      )}
      <div className={css.rulesHead}>
        <span>Rules: the first that matches decides</span>
        <Button
          size="compact-xs"
          variant="default"
          leftSection={<IconPlus size={13} />}
          data-testid="add-rule"
          onClick={() => edit(withRule(draft, draftRule({ type: "cut" })))}
        >
          Rule
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
              edit(withChanged(draft, rule.key, part), `${rule.key} ${Object.keys(part)}`)
            }
            onDelete={() => edit(withoutRule(draft, rule.key))}
            onMove={(to) => edit(withMoved(draft, rule.key, to))}
            onLift={setDragged}
            onOver={() => {
              if (dragged !== null && dragged !== rule.key)
                edit(withMoved(draft, dragged, at), `dragged ${dragged}`);
            }}
          />
        ))}
      </ol>
      {draft.rules.length === 0 && (
        <p className={panels.note} style={{ margin: 0 }}>
          No rules of this customer yet. Add one, or correct edges in the picture and keep what is
          learned from that.
        </p>
      )}
      {draft.overrules && inherited}
      <div className={css.outcome}>
        {preview.error !== null ? (
          <p className={css.fault} role="alert" data-testid="profile-fault">
            {preview.error.message}
          </p>
        ) : (
          preview.data && (
            <>
              <p className={panels.note} style={{ margin: 0 }} data-testid="profile-outcome">
                {changes.length === 0
                  ? "Nothing in this drawing changes"
                  : `In this drawing ${count(
                      changes.reduce((sum, { edges }) => sum + edges.length, 0),
                      "edge",
                    )} change`}
                {preview.data.open > 0 &&
                  `; no rule takes ${count(preview.data.open, "edge")}: their shape decides, or you`}
                .{(drawing?.overrides ?? 0) > 0 && " What you decided by hand stays."}
              </p>
              <Changes changes={changes} />
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
            Keep and use it
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
  /** null while the service has not said what they take. */
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
          {rules === null ? "…" : `${count(rules.length, "rule")} · ${count(edges, "edge")}`}
        </span>
      </button>
      {open &&
        rules?.map((rule, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a profile may have two rules alike
          <RuleWords key={`${at} ${rule.words}`} rule={rule} />
        ))}
    </div>
  );
}

/** Out to a file, in from one, and away. */
function Files({ profile }: { profile: Profile }) {
  const input = useRef<HTMLInputElement>(null);
  const set = usePage((page) => page.set);
  return (
    <span style={{ display: "flex" }}>
      <Tooltip label="Export as TOML">
        <ActionIcon
          component="a"
          href={service.profileUrl(profile.name)}
          download={`${profile.name}.toml`}
          variant="subtle"
          color="gray"
          aria-label="Export as TOML"
          data-testid="export-profile"
        >
          <IconDownload size={16} />
        </ActionIcon>
      </Tooltip>
      <Tooltip label="Import a TOML file">
        <ActionIcon
          variant="subtle"
          color="gray"
          aria-label="Import a TOML file"
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
            void importProfile(file).then((name) => name !== null && set({ editing: name }));
        }}
      />
      {!profile.shipped && (
        <Tooltip label="Delete this profile">
          <ActionIcon
            variant="subtle"
            color="gray"
            aria-label="Delete this profile"
            data-testid="delete-profile"
            onClick={() => {
              set({ editing: null });
              void forgetProfile(profile);
            }}
          >
            <IconTrash size={16} />
          </ActionIcon>
        </Tooltip>
      )}
    </span>
  );
}
