/** Old and new values of the settings that were measured, and the button that saves them. */

import { Button, Checkbox, Table, Text, Title } from "@mantine/core";
import { useState } from "react";
import { libraryService } from "../../../api/library";
import type { Bench, Figure, TestPiece } from "../../../api/testpieces";
import { formatFixed, withMinusSign } from "../../../language/numbers";
import { translate } from "../../../language/translate";
import { errorText, messageText } from "../../../messages/translateMessage";
import { savingOf, useRefusal } from "../../../state/accounts/accounts";
import { refreshLibrary } from "../../../state/library/definitions";
import { ownerOf, withFigures } from "../../../state/library/measured";
import { Refusal } from "../../accounts/Permitted";
import css from "./testpieces.module.css";

interface Props {
  readonly piece: TestPiece;
  readonly bench: Bench;
  readonly figures: readonly Figure[];
}

const DIGITS: Readonly<Record<Figure["unit"], number>> = {
  mm: 3,
  degrees: 3,
  factor: 5,
  "per-mm": 4,
};
const UNITS: Readonly<Record<Figure["unit"], string>> = {
  mm: "\u202fmm",
  degrees: "°",
  factor: "",
  "per-mm": "\u202f/mm",
};

const valueText = (value: number, unit: Figure["unit"]): string =>
  `${withMinusSign(formatFixed(value, DIGITS[unit]))}${UNITS[unit]}`;

export function Figures({ piece, bench, figures }: Props) {
  const stored = figures.filter(({ shelf }) => shelf !== null);
  const shelf = stored[0]?.shelf ?? null;
  const [chosen, setChosen] = useState<ReadonlySet<string>>(
    new Set(stored.filter(({ significant }) => significant).map(({ name }) => name)),
  );
  return (
    <>
      <Title order={2} fz={16} mt={22} mb={6}>
        {translate("testPieces.stepSave")}
      </Title>
      <section className={css.table} aria-label={translate("testPieces.stepSave")}>
        <Table data-testid="piece-figures">
          <Table.Thead>
            <Table.Tr>
              <Table.Th>{translate("testPieces.setting")}</Table.Th>
              <Table.Th>{translate("testPieces.before")}</Table.Th>
              <Table.Th>{translate("testPieces.after")}</Table.Th>
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {figures.map(({ name, label, before, after, uncertainty, unit, ...figure }) => (
              <Table.Tr key={name} data-testid={`figure-${name}`}>
                <Table.Td>
                  {figure.shelf === null ? (
                    <>
                      {messageText(label)}
                      <Text fz={12} c="ink.2">
                        {translate("testPieces.inTheController")}
                      </Text>
                    </>
                  ) : (
                    <Checkbox
                      label={messageText(label)}
                      description={
                        figure.significant ? null : translate("testPieces.notSignificant")
                      }
                      checked={chosen.has(name)}
                      onChange={({ currentTarget: { checked } }) => {
                        const next = new Set(chosen);
                        if (checked) next.add(name);
                        else next.delete(name);
                        setChosen(next);
                      }}
                    />
                  )}
                </Table.Td>
                <Table.Td>{valueText(before, unit)}</Table.Td>
                <Table.Td>
                  {valueText(after, unit)}
                  <Text fz={12} c="ink.2">
                    {translate("testPieces.difference", {
                      value: valueText(after - before, unit),
                      uncertainty: valueText(uncertainty, unit),
                    })}
                  </Text>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </Table>
      </section>
      {shelf !== null && shelf !== "tools" && (
        <Save
          key={shelf}
          shelf={shelf}
          bench={bench}
          figures={stored.filter(({ name }) => chosen.has(name))}
          note={translate("testPieces.noteOf", { name: messageText(piece.name) })}
        />
      )}
    </>
  );
}

interface SaveProps {
  readonly shelf: "machines" | "boards";
  readonly bench: Bench;
  readonly figures: readonly Figure[];
  readonly note: string;
}

function Save({ shelf, bench, figures, note }: SaveProps) {
  const [saved, setSaved] = useState<number | null>(null);
  const [failure, setFailure] = useState<unknown>(null);
  const refusal = useRefusal(savingOf(shelf));
  const name = ownerOf(shelf, bench);
  const save = async () => {
    setFailure(null);
    try {
      const { fields, version, shipped } = await libraryService.definition(shelf, name);
      if (shipped) throw new Error(translate("testPieces.copyItFirst", { name }));
      const body = withFigures(fields, figures);
      const made = await libraryService.putDefinition({ shelf, name }, body, {
        version,
        note: note.slice(0, 200),
      });
      setSaved(made.version);
      await refreshLibrary();
    } catch (reason) {
      setFailure(reason);
    }
  };
  if (saved !== null) {
    return (
      <Text mt={12} role="status" data-testid="piece-saved">
        {translate("testPieces.saved", { name, version: saved })}
      </Text>
    );
  }
  return (
    <>
      {failure instanceof Error && (
        <Text my={8} c="var(--bad-ink)" role="alert" data-testid="piece-save-fault">
          {errorText(failure)}
        </Text>
      )}
      <Refusal reason={refusal} />
      <Button
        mt={12}
        disabled={refusal !== null || figures.length === 0}
        onClick={() => void save()}
        data-testid="piece-save"
      >
        {translate("testPieces.saveAsNewVersion", { name })}
      </Button>
    </>
  );
}
