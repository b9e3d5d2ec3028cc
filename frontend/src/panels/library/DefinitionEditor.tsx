/** Editor of a machine, a board or a tool: form, save, copy, download, delete, versions. */

import { Button, Group, Text, TextInput, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useEffect, useMemo, useRef, useState } from "react";
import { ServiceError } from "../../api/errors";
import { type Definition, type LibraryEntry, libraryService } from "../../api/library";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { savingOf, useRefusal } from "../../state/accounts/accounts";
import {
  differences,
  type Fields,
  faultsOf,
  faultTree,
  refreshLibrary,
  sentFields,
  withValue,
} from "../../state/library/definitions";
import { formSchema } from "../../state/library/formSchema";
import { queries } from "../../state/queries";
import { Refusal } from "../accounts/Permitted";
import panels from "../shared/panels.module.css";
import { CalibrationForm } from "./CalibrationForm";
import { ConflictCard } from "./ConflictCard";
import { CopyForm } from "./CopyForm";
import { DefinitionForm } from "./DefinitionForm";
import { DefinitionHistory } from "./DefinitionHistory";
import css from "./library.module.css";
import { TestPieces } from "./testpieces/TestPieces";

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
  // Stays open when a new version is saved, with which the form begins anew.
  const [measuring, setMeasuring] = useState(false);
  if (error !== null) {
    return (
      <Text my={8} c="var(--bad-ink)" role="alert">
        {errorText(error)}
      </Text>
    );
  }
  if (definition === undefined || schema === undefined)
    return <p>{translate("definitionEditor.loading")}</p>;
  const { tool } = definition.fields as { tool?: { kind?: string } };
  return (
    <>
      {measuring && <TestPieces entry={entry} kind={tool?.kind ?? null} />}
      <Editor
        key={`${definition.name} ${definition.version}`}
        definition={definition}
        schema={schema}
        onOpen={onOpen}
        measuring={measuring}
        onMeasure={() => setMeasuring(!measuring)}
      />
    </>
  );
}

interface EditorProps {
  readonly definition: Definition;
  readonly schema: unknown;
  readonly onOpen: (entry: Entry | null) => void;
  readonly measuring: boolean;
  /** Shows or hides the test pieces. */
  readonly onMeasure: () => void;
}

/** What another person has saved in between. */
interface Conflict {
  readonly theirs: Definition;
  readonly by: string;
}

function Editor({ definition, schema, onOpen, measuring, onMeasure }: EditorProps) {
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
  const changed = differences(definition.fields, fields).length > 0;
  const fieldFaults = useMemo(() => faultTree(faultsOf(failure), fields), [failure, fields]);
  const forForm = useMemo(() => formSchema(schema), [schema]);
  const readOnly = shipped || refusal !== null;

  // The first fault comes into view, with the text beside its field.
  useEffect(() => {
    if (Object.keys(faultsOf(failure)).length === 0) return;
    // The form shows the faults one drawing later than the page.
    const drawn = requestAnimationFrame(() => {
      const field = form.current?.querySelector<HTMLElement>("[aria-invalid=true]");
      field?.scrollIntoView({ block: "center" });
      field?.focus({ preventScroll: true });
    });
    return () => cancelAnimationFrame(drawn);
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
        const theirs = await libraryService.definition(shelf, name);
        const [last] = await libraryService.definitionVersions(shelf, name);
        setConflict({ theirs, by: last?.by ?? "" });
      } else setFailure(error);
    }
  };
  const save = (basedOn: number) =>
    attempt(() =>
      libraryService.putDefinition({ shelf, name }, sentFields(fields), { version: basedOn, note }),
    );

  const restore = (old: Definition) =>
    attempt(() =>
      libraryService.putDefinition({ shelf, name }, old.fields, {
        version,
        note: translate("definitionHistory.restoredFrom", { version: old.version }),
      }),
    );

  const count = Object.keys(faults).length;
  const alert = failure instanceof Error && (
    <Text component="div" my={8} c="var(--bad-ink)" role="alert" data-testid="definition-fault">
      {count === 0 ? (
        errorText(failure)
      ) : (
        <>
          {translate("definitionEditor.notSavedValuesNeedA", { count })}
          <details>
            <summary>{translate("definitionEditor.allFaults")}</summary>
            {errorText(failure)}
          </details>
        </>
      )}
    </Text>
  );
  return (
    <>
      <div className={panels.head}>
        <Button hiddenFrom="sm" variant="default" onClick={() => onOpen(null)}>
          {translate("definitionEditor.allEntries")}
        </Button>
        <Title order={1} fz={20}>
          {title}
        </Title>
        <Text span fz={11} c="ink.3">
          {shipped
            ? translate("definitionEditor.suppliedWithKnifetip")
            : `${name} · ${translate("definitionEditor.version", { version })}`}
        </Text>
        <Button
          variant={shipped ? "filled" : "default"}
          disabled={refusal !== null}
          title={refusal ?? undefined}
          onClick={() => setCopying(true)}
          data-testid="copy-definition"
        >
          {translate("definitionEditor.copy")}
        </Button>
        <Button
          component="a"
          variant="default"
          href={libraryService.definitionUrl(shelf, name)}
          download={`${name}.toml`}
          data-testid="download-definition"
        >
          {translate("definitionEditor.downloadToml")}
        </Button>
        <Button
          variant="default"
          aria-expanded={measuring}
          onClick={onMeasure}
          data-testid="measure"
        >
          {translate("testPieces.measureWithATestPiece")}
        </Button>
        {!shipped && (
          <Button
            color="red"
            variant={deleting ? "filled" : "subtle"}
            disabled={refusal !== null}
            title={refusal ?? undefined}
            onClick={() =>
              deleting
                ? void attempt(() => libraryService.deleteDefinition(shelf, name, version), null)
                : setDeleting(true)
            }
          >
            {deleting
              ? translate("definitionEditor.deleteNow")
              : translate("definitionEditor.delete")}
          </Button>
        )}
      </div>
      {copying && (
        <CopyForm definition={definition} onDone={onOpen} onCancel={() => setCopying(false)} />
      )}
      {refusal !== null ? (
        <Refusal reason={refusal} />
      ) : (
        shipped && <p>{translate("definitionEditor.thisEntryIsReadOnly")}</p>
      )}
      {(shipped || deleting) && alert}
      <div ref={form}>
        <DefinitionForm
          schema={forForm}
          fields={fields}
          faults={fieldFaults}
          readOnly={readOnly}
          setAt={(path, value) => setFields((now) => withValue(now, path, value))}
          after={{
            deflection: !readOnly && (
              <CalibrationForm
                key="calibration"
                board={name}
                onUse={(tool, found) =>
                  setFields((now) => withValue(now, ["deflection", tool], found))
                }
              />
            ),
          }}
        />
      </div>
      {!shipped && refusal === null && (
        <section className={css.saveBar} aria-label={translate("definitionEditor.save")}>
          {!deleting && alert}
          {conflict !== null && (
            <ConflictCard
              {...conflict}
              mine={fields}
              onTakeTheirs={() => void refreshLibrary()}
              onKeepMine={() => void save(conflict.theirs.version)}
            />
          )}
          <Group gap={8} mt={8} align="flex-end">
            <TextInput
              label={translate("definitionEditor.whatIsChangedAndWhy")}
              value={note}
              maxLength={200}
              onChange={(event) => setNote(event.currentTarget.value)}
            />
            <Button
              disabled={!changed}
              onClick={() => void save(version)}
              data-testid="save-definition"
            >
              {translate("definitionEditor.saveAsVersion", { version: version + 1 })}
            </Button>
          </Group>
        </section>
      )}
      <DefinitionHistory
        definition={definition}
        onRestore={readOnly ? null : (old) => void restore(old)}
      />
    </>
  );
}
