/** One carton style: its form, the picture of the carton, and the button that makes a drawing. */

import { Button, Loader, Select, Text, Title } from "@mantine/core";
import { useDebouncedValue } from "@mantine/hooks";
import { useQuery } from "@tanstack/react-query";
import { useEffect, useMemo, useState } from "react";
import { type CartonFields, type CartonStyle, cartonService } from "../../api/cartons";
import { translate } from "../../language/translate";
import { errorText, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { withValue } from "../../state/library/definitions";
import { useBoards } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import { DefinitionForm } from "../library/DefinitionForm";
import { cartonSchema, fieldFaults } from "./cartonSchema";
import css from "./cartons.module.css";

/** Pause after the last change before the picture is drawn again (ms). */
const PAUSE = 200;
const NOTHING = {};

export function CartonEditor({ style }: { readonly style: CartonStyle }) {
  const [fields, setFields] = useState<CartonFields>(style.example);
  const [board, setBoard] = useState(style.board);
  const [drawing, setDrawing] = useState(false);
  const [failure, setFailure] = useState<Error | null>(null);
  const { data: boards = [] } = useBoards();
  const refusal = useRefusal("POST /api/v1/cartons");
  const schema = useMemo(() => cartonSchema(style), [style]);
  const [wanted] = useDebouncedValue(JSON.stringify({ fields, board }), PAUSE);
  const picture = useQuery({
    queryKey: ["carton", style.code, wanted],
    queryFn: ({ signal }) => {
      const { fields, board } = JSON.parse(wanted) as { fields: CartonFields; board: string };
      return cartonService.picture(style.code, fields, board, signal);
    },
    retry: false,
  });
  // The last picture stays while another one is drawn, and while the dimensions are impossible.
  const [shown, setShown] = useState<string>();
  useEffect(() => {
    if (picture.data !== undefined) setShown(picture.data);
  }, [picture.data]);
  const error = failure ?? picture.error;
  const faults = useMemo(() => fieldFaults(error, style), [error, style]);
  const suits = new Set(style.materials);

  const make = async () => {
    setDrawing(true);
    setFailure(null);
    try {
      const made = await cartonService.draw(style.code, fields, board);
      showDrawing(made.id);
      useUiStore.getState().set({ board });
    } catch (reason) {
      setFailure(reason instanceof Error ? reason : new Error(String(reason)));
      setDrawing(false);
    }
  };

  return (
    <div className={css.editor} data-testid={`carton-${style.code}`}>
      <form
        className={css.form}
        onSubmit={(event) => {
          event.preventDefault();
          void make();
        }}
      >
        <Title order={1} fz={20}>
          {messageText(style.name)}
        </Title>
        <Text c="ink.2">{messageText(style.description)}</Text>
        <Select
          label={translate("boardSelect.board")}
          data={boards.map(({ name, title, material }) => ({
            value: name,
            label: suits.has(material)
              ? title || name
              : translate("cartonPage.unusualBoard", { board: title || name }),
          }))}
          value={board}
          allowDeselect={false}
          searchable
          onChange={(name) => {
            setFailure(null);
            if (name !== null) setBoard(name);
          }}
          data-testid="carton-board"
        />
        <DefinitionForm
          schema={schema}
          fields={fields}
          faults={faults}
          setAt={(path, value) => {
            setFailure(null);
            setFields((before) => withValue(before, path, value));
          }}
          after={NOTHING}
          readOnly={false}
        />
        {error !== null && Object.keys(faults).length === 0 && (
          <Text c="var(--bad-ink)" role="alert">
            {errorText(error)}
          </Text>
        )}
        <Refusal reason={refusal} />
        <Button
          type="submit"
          size="md"
          loading={drawing}
          disabled={refusal !== null || picture.error !== null}
          data-testid="carton-draw"
        >
          {translate("cartonPage.makeDrawing")}
        </Button>
      </form>
      <figure className={css.preview} data-stale={picture.error !== null}>
        {shown === undefined ? (
          picture.error === null && <Loader />
        ) : (
          <img
            src={`data:image/svg+xml,${encodeURIComponent(shown)}`}
            alt={translate("cartonPage.pictureOf", { name: messageText(style.name) })}
            data-testid="carton-picture"
          />
        )}
      </figure>
    </div>
  );
}
