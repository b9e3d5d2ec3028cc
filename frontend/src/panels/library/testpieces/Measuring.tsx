/** What was measured on a test piece, and the settings that follow from it. */

import { Button, NumberInput, Text, Title } from "@mantine/core";
import { useState } from "react";
import { ServiceError } from "../../../api/errors";
import { type Bench, type Figure, type TestPiece, testPieceService } from "../../../api/testpieces";
import { schemaTexts } from "../../../language/schemaTexts";
import { translate } from "../../../language/translate";
import { errorText, messageText } from "../../../messages/translateMessage";
import { givenMeasures, measureFields } from "../../../state/library/measured";
import css from "../library.module.css";
import { Figures } from "./Figures";

interface Props {
  readonly piece: TestPiece;
  readonly bench: Bench;
}

const shown = (text: string): string => schemaTexts[text] ?? text;

export function Measuring({ piece, bench }: Props) {
  const fields = measureFields(piece);
  const [typed, setTyped] = useState<Readonly<Record<string, number | "">>>({});
  const [figures, setFigures] = useState<readonly Figure[] | null>(null);
  const [failure, setFailure] = useState<unknown>(null);
  const given = givenMeasures(fields, typed);
  const faulty =
    failure instanceof ServiceError ? failure.problem.source[0]?.split(".").at(-1) : undefined;
  const atField = fields.some(({ name }) => name === faulty);
  const compute = async () => {
    if (given === null) return;
    setFailure(null);
    setFigures(null);
    try {
      setFigures(await testPieceService.figures(piece.code, bench, given));
    } catch (reason) {
      setFailure(reason);
    }
  };
  return (
    <>
      <Title order={2} fz={16} mt={22} mb={6}>
        {translate("testPieces.stepMeasure")}
      </Title>
      <Text mb={10}>{messageText(piece.instruction)}</Text>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          void compute();
        }}
      >
        <div className={css.fields}>
          {fields.map(({ name, title, description, whole, initial }) => (
            <NumberInput
              key={name}
              label={shown(title)}
              description={shown(description)}
              value={typed[name] ?? initial ?? ""}
              allowDecimal={!whole}
              error={failure instanceof Error && name === faulty ? errorText(failure) : null}
              onChange={(value) => {
                setFigures(null);
                setFailure(null);
                setTyped({ ...typed, [name]: typeof value === "number" ? value : "" });
              }}
              data-testid={`measure-${name}`}
            />
          ))}
        </div>
        {failure instanceof Error && !atField && (
          <Text my={8} c="var(--bad-ink)" role="alert">
            {errorText(failure)}
          </Text>
        )}
        <Button type="submit" mt={12} disabled={given === null} data-testid="piece-compute">
          {translate("testPieces.compute")}
        </Button>
      </form>
      {figures !== null && <Figures piece={piece} bench={bench} figures={figures} />}
    </>
  );
}
