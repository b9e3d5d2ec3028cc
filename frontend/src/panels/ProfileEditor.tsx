/** A profile, rule by rule: what each takes of the drawing that is open is counted as one types. */

import { ActionIcon, Button, Select, Skeleton, Switch, TextInput, Tooltip } from "@mantine/core";
import { IconArrowLeft, IconDownload, IconPlus, IconTrash, IconUpload } from "@tabler/icons-react";
import { useEffect, useRef, useState } from "react";
import { type Profile, service } from "../api/client";
import {
  type Draft,
  draftOf,
  draftRule,
  withChanged,
  withMoved,
  withoutRule,
  withRule,
} from "../state/draft";
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
  // Another version is another thing to edit.
  return <Editor key={`${name} ${profile.version}`} profile={profile} profiles={profiles} />;
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

function Editor({ profile, profiles }: Props) {
  const { data: drawing } = useDrawing();
  const busy = usePage((page) => page.busy);
  const set = usePage((page) => page.set);
  const [first] = useState(() => draftOf(profile));
  const [draft, setDraft] = useState<Draft>(first);
  const [dragged, setDragged] = useState<number | null>(null);
  const preview = usePreview(drawing?.id ?? null, draft);
  const changes = preview.data?.changes ?? [];
  const own = preview.data?.rules.filter(({ inherited }) => !inherited) ?? [];
  const theirs = preview.data?.rules.filter(({ inherited }) => inherited) ?? [];
  const untitled = draft.title.trim() === "";
  const touched = draft !== first;

  useEffect(() => {
    set({ proposed: proposedOf(changes) });
    return () => set({ proposed: [] });
  }, [changes, set]);

  const close = () => set({ editing: null, proposed: [] });
  const save = async () => {
    const taken = profiles.map((one) => one.name);
    const under = profile.shipped ? freeName(draft.title, taken) : profile.name;
    if (await keepDraft(under, draft)) set({ editing: profile.shipped ? under : profile.name });
  };
  const inherited = draft.extends !== null && (
    <Inherited
      title={profiles.find(({ name }) => name === draft.extends)?.title ?? draft.extends}
      rules={theirs}
    />
  );
  return (
    <div className={css.editor} data-testid="profile-editor">
      <div className={css.head}>
        <Tooltip label="Back to the drawing">
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
        onChange={(event) => setDraft({ ...draft, title: event.currentTarget.value })}
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
        onChange={(value) => setDraft({ ...draft, extends: value })}
      />
      {draft.extends !== null && (
        <Switch
          size="xs"
          label="The customer's rules come first"
          checked={draft.overrules}
          onChange={(event) => setDraft({ ...draft, overrules: event.currentTarget.checked })}
        />
      )}
      <div className={css.rulesHead}>
        <span>Rules, of which the first that matches decides</span>
        <Button
          size="compact-xs"
          variant="default"
          leftSection={<IconPlus size={13} />}
          data-testid="add-rule"
          onClick={() => setDraft(withRule(draft, draftRule({ type: "cut" })))}
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
            onChange={(part) => setDraft(withChanged(draft, rule.key, part))}
            onDelete={() => setDraft(withoutRule(draft, rule.key))}
            onMove={(to) => setDraft(withMoved(draft, rule.key, to))}
            onLift={setDragged}
            onOver={() => {
              if (dragged !== null && dragged !== rule.key) setDraft(withMoved(draft, dragged, at));
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
                .
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
          <Button size="xs" variant="default" onClick={close}>
            {touched ? "Discard" : "Close"}
          </Button>
        </div>
      </div>
    </div>
  );
}

function Inherited({ title, rules }: { title: string; rules: Profile["rules"] }) {
  const [open, setOpen] = useState(false);
  const edges = (rules as readonly { edges?: number }[]).reduce(
    (sum, rule) => sum + (rule.edges ?? 0),
    0,
  );
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
          {count(rules.length, "rule")} · {count(edges, "edge")}
        </span>
      </button>
      {open &&
        rules.map((rule, at) => (
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
