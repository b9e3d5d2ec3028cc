/** Editor of a machine, a board or a tool: form, save, copy, download, delete, versions. */

import { Button, TextInput } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { type Definition, type LibraryEntry, service } from "../api/client";
import { errorText } from "../messages/render";
import { type Fields, faultsOf, GROUPS, refreshLibrary, type Schema } from "../state/definitions";
import { slugOf } from "../state/draft";
import { queries } from "../state/queries";
import { DefinitionField } from "./DefinitionForm";
import { DefinitionHistory } from "./DefinitionHistory";
import css from "./library.module.css";

type Entry = Pick<LibraryEntry, "shelf" | "name">;

interface Props {
  readonly entry: Entry;
  readonly onOpen: (entry: Entry | null) => void;
}

export function DefinitionEditor({ entry, onOpen }: Props) {
  const { data: definition, error } = useQuery(queries.definition(entry.shelf, entry.name));
  const { data: schema } = useQuery(queries.librarySchema(entry.shelf));
  if (error !== null) return <p className={css.fault}>{errorText(error)}</p>;
  if (definition === undefined || schema === undefined) return null;
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

function Editor({ definition, schema, onOpen }: EditorProps) {
  const { shelf, name, shipped, version, title } = definition;
  const [fields, setFields] = useState<Fields>(definition.fields);
  const [note, setNote] = useState("");
  const [failure, setFailure] = useState<unknown>(null);
  const [deleting, setDeleting] = useState(false);
  const faults = faultsOf(failure);
  const changed = fields !== definition.fields;

  const attempt = async (action: () => Promise<unknown>, next?: Entry | null) => {
    setFailure(null);
    try {
      await action();
      await refreshLibrary();
      if (next !== undefined) onOpen(next);
    } catch (error) {
      setFailure(error);
    }
  };
  const copy = () => {
    const copied = `${slugOf(name).slice(0, 50)}-${Date.now().toString(36)}`;
    const body = { ...definition.fields, title: `${title} (copy)` };
    return attempt(
      () => service.putDefinition({ shelf, name: copied }, body, { version: null, note }),
      { shelf, name: copied },
    );
  };
  const save = () =>
    attempt(() => service.putDefinition({ shelf, name }, { ...fields }, { version, note }));

  const alert = failure instanceof Error && (
    <p className={css.fault} role="alert" data-testid="definition-fault">
      {errorText(failure)}
    </p>
  );
  const grouped = new Set(Object.values(GROUPS[shelf]).flat());
  const others = Object.keys(schema.properties ?? {}).filter((key) => !grouped.has(key));
  return (
    <>
      <div className={css.head}>
        <h1>{title}</h1>
        <span className={css.mark}>
          {shipped ? "part of knifetip" : `${name} · version ${version}`}
        </span>
        <Button
          variant={shipped ? "filled" : "default"}
          onClick={copy}
          data-testid="copy-definition"
        >
          Copy
        </Button>
        <Button
          component="a"
          variant="default"
          href={service.definitionUrl(shelf, name)}
          download={`${name}.toml`}
        >
          Download TOML
        </Button>
        {!shipped && (
          <Button
            color="red"
            variant={deleting ? "filled" : "subtle"}
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
      {shipped && <p>This entry is read-only. Copy it to change it.</p>}
      {(shipped || deleting) && alert}
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
                schema={schema.properties?.[key] ?? {}}
                root={schema}
                value={fields[key]}
                faults={faults}
                readOnly={shipped}
                onChange={(value) => setFields({ ...fields, [key]: value })}
              />
            ))}
          </div>
          {group === "More" && (
            <p>Settings of the controller and carriages can be changed in the TOML file.</p>
          )}
        </section>
      ))}
      {!shipped && (
        <section className={css.group}>
          {!deleting && alert}
          <div className={css.add}>
            <TextInput
              label="What is changed, and why"
              value={note}
              maxLength={200}
              onChange={(event) => setNote(event.currentTarget.value)}
            />
            <Button disabled={!changed} onClick={save} data-testid="save-definition">
              Save as version {version + 1}
            </Button>
          </div>
        </section>
      )}
      <DefinitionHistory definition={definition} />
    </>
  );
}
