/** Editor of a machine, a board or a tool: form, save, copy, download, delete, versions. */

import { Button, TextInput } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useEffect, useRef, useState } from "react";
import { type Definition, type LibraryEntry, ServiceError, service } from "../api/client";
import { errorText } from "../messages/render";
import { savingOf, useRefusal } from "../state/accounts";
import {
  type Fields,
  faultsOf,
  fieldsOf,
  GROUPS,
  refreshLibrary,
  type Schema,
} from "../state/definitions";
import { pluralize } from "../state/format";
import { queries } from "../state/queries";
import { CalibrationForm } from "./CalibrationForm";
import { ConflictCard } from "./ConflictCard";
import { CopyForm } from "./CopyForm";
import { DefinitionField } from "./DefinitionForm";
import { DefinitionHistory } from "./DefinitionHistory";
import css from "./library.module.css";
import { Refusal } from "./Permitted";

type Entry = Pick<LibraryEntry, "shelf" | "name">;

interface Props {
  readonly entry: Entry;
  readonly onOpen: (entry: Entry | null) => void;
}

export function DefinitionEditor({ entry, onOpen }: Props) {
  const { data: definition, error } = useQuery({
    ...queries.definition(entry.shelf, entry.name),
    // What is being edited must not change under the hands of the person.
    refetchOnWindowFocus: false,
    refetchOnReconnect: false,
  });
  const { data: schema } = useQuery(queries.librarySchema(entry.shelf));
  if (error !== null) {
    return (
      <p className={css.fault} role="alert">
        {errorText(error)}
      </p>
    );
  }
  if (definition === undefined || schema === undefined) return <p>Loading …</p>;
  return (
    <Editor
      key={`${definition.name} ${definition.version}`}
      definition={definition}
      schema={schema as Schema}
      onOpen={onOpen}
    />
  );
}

interface EditorProps {
  readonly definition: Definition;
  readonly schema: Schema;
  readonly onOpen: (entry: Entry | null) => void;
}

/** What another person has saved in between. */
interface Conflict {
  readonly theirs: Definition;
  readonly by: string;
}

function Editor({ definition, schema, onOpen }: EditorProps) {
  const { shelf, name, shipped, version, title } = definition;
  const [fields, setFields] = useState<Fields>(definition.fields);
  const [note, setNote] = useState("");
  const [failure, setFailure] = useState<unknown>(null);
  const [conflict, setConflict] = useState<Conflict | null>(null);
  const [deleting, setDeleting] = useState(false);
  const [copying, setCopying] = useState(false);
  const form = useRef<HTMLDivElement>(null);
  const refusal = useRefusal(savingOf(shelf));
  const faults = faultsOf(failure);
  const changed = fields !== definition.fields;
  const set = (key: string, value: unknown) => setFields({ ...fields, [key]: value });

  // The first fault comes into view, with the text beside its field.
  useEffect(() => {
    if (Object.keys(faultsOf(failure)).length === 0) return;
    const field = form.current?.querySelector<HTMLElement>("[aria-invalid=true]");
    field?.scrollIntoView({ block: "center" });
    field?.focus({ preventScroll: true });
  }, [failure]);

  const attempt = async (action: () => Promise<unknown>, next?: Entry | null) => {
    setFailure(null);
    setConflict(null);
    try {
      await action();
      if (next !== undefined) onOpen(next);
      await refreshLibrary();
    } catch (error) {
      if (error instanceof ServiceError && error.problem.status === 412) {
        const theirs = await service.definition(shelf, name);
        const [last] = await service.definitionVersions(shelf, name);
        setConflict({ theirs, by: last?.by ?? "" });
      } else setFailure(error);
    }
  };
  const save = (basedOn: number) =>
    attempt(() =>
      service.putDefinition({ shelf, name }, { ...fields }, { version: basedOn, note }),
    );

  const count = Object.keys(faults).length;
  const alert = failure instanceof Error && (
    <div className={css.fault} role="alert" data-testid="definition-fault">
      {count === 0 ? (
        errorText(failure)
      ) : (
        <>
          Not saved. {pluralize(count, "value needs", "values need")} a correction; each is marked
          in the form.
          <details>
            <summary>All faults</summary>
            {errorText(failure)}
          </details>
        </>
      )}
    </div>
  );
  const all = fieldsOf(schema, fields);
  const grouped = new Set(Object.values(GROUPS[shelf]).flat());
  const others = Object.keys(all).filter((key) => !grouped.has(key));
  return (
    <>
      <div className={css.head}>
        <Button className={css.back ?? ""} variant="default" onClick={() => onOpen(null)}>
          All entries
        </Button>
        <h1>{title}</h1>
        <span className={css.mark}>
          {shipped ? "supplied with knifetip" : `${name} · version ${version}`}
        </span>
        <Button
          variant={shipped ? "filled" : "default"}
          disabled={refusal !== null}
          title={refusal ?? undefined}
          onClick={() => setCopying(true)}
          data-testid="copy-definition"
        >
          Copy
        </Button>
        <Button
          component="a"
          variant="default"
          href={service.definitionUrl(shelf, name)}
          download={`${name}.toml`}
          data-testid="download-definition"
        >
          Download TOML
        </Button>
        {!shipped && (
          <Button
            color="red"
            variant={deleting ? "filled" : "subtle"}
            disabled={refusal !== null}
            title={refusal ?? undefined}
            onClick={() =>
              deleting
                ? void attempt(() => service.deleteDefinition(shelf, name, version), null)
                : setDeleting(true)
            }
          >
            {deleting ? "Delete now" : "Delete"}
          </Button>
        )}
      </div>
      {copying && (
        <CopyForm definition={definition} onDone={onOpen} onCancel={() => setCopying(false)} />
      )}
      {refusal !== null ? (
        <Refusal reason={refusal} />
      ) : (
        shipped && <p>This entry is read-only. Copy it to change it.</p>
      )}
      {(shipped || deleting) && alert}
      <div ref={form}>
        {[
          ...Object.entries(GROUPS[shelf]),
          ...(others.length > 0 ? [["More", others] as const] : []),
        ].map(([group, keys]) => (
          <section key={group} className={css.group}>
            <h2>{group}</h2>
            <div className={css.fields}>
              {keys.map((key) => (
                <DefinitionField
                  key={key}
                  name={key}
                  path={key}
                  schema={all[key] ?? {}}
                  root={schema}
                  value={fields[key]}
                  faults={faults}
                  readOnly={shipped || refusal !== null}
                  onChange={(value) => set(key, value)}
                />
              ))}
            </div>
            {keys.includes("deflection") && !shipped && refusal === null && (
              <CalibrationForm
                board={name}
                onUse={(tool, deflection) =>
                  set("deflection", { ...(fields.deflection as Fields), [tool]: deflection })
                }
              />
            )}
          </section>
        ))}
      </div>
      {!shipped && refusal === null && (
        <section className={css.saveBar} aria-label="Save">
          {!deleting && alert}
          {conflict !== null && (
            <ConflictCard
              {...conflict}
              mine={fields}
              onTakeTheirs={() => void refreshLibrary()}
              onKeepMine={() => void save(conflict.theirs.version)}
            />
          )}
          <div className={css.add}>
            <TextInput
              label="What is changed, and why"
              value={note}
              maxLength={200}
              onChange={(event) => setNote(event.currentTarget.value)}
            />
            <Button
              disabled={!changed}
              onClick={() => void save(version)}
              data-testid="save-definition"
            >
              Save as version {version + 1}
            </Button>
          </div>
        </section>
      )}
      <DefinitionHistory definition={definition} />
    </>
  );
}
