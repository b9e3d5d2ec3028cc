/** Measures a tool with a test piece: choose and order the piece, type the measures, save. */

import { Button, Group, Select, Text, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import type { Shelf } from "../../../api/library";
import { type Bench, testPieceService } from "../../../api/testpieces";
import { translate } from "../../../language/translate";
import { errorText, messageText } from "../../../messages/translateMessage";
import { useRefusal } from "../../../state/accounts/accounts";
import { chosenEntry } from "../../../state/library/measured";
import { DEFAULT_OPTIONS } from "../../../state/order/options";
import { useBoards, useMachines } from "../../../state/queries";
import { showDrawing } from "../../../state/routes";
import { useUiStore } from "../../../state/store";
import { Refusal } from "../../accounts/Permitted";
import css from "../library.module.css";
import { Measuring } from "./Measuring";
import { PiecePicture } from "./PiecePicture";

interface Props {
  /** The entry of the library from which the measuring begins. */
  readonly entry: { readonly shelf: Shelf; readonly name: string };
  /** Kind of the tool, if the entry is a tool. */
  readonly kind: string | null;
}

export function TestPieces({ entry, kind }: Props) {
  const { data: all = [] } = useMachines();
  const { data: boards = [] } = useBoards();
  const { data: pieces = [], error } = useQuery({
    queryKey: ["testPieces"],
    queryFn: ({ signal }) => testPieceService.list(signal),
    staleTime: Number.POSITIVE_INFINITY,
  });
  const machines = all.filter(
    ({ stations }) => kind === null || stations.some(({ tool }) => tool.kind === kind),
  );
  const page = useUiStore.getState();
  const measuredMachine = entry.shelf === "machines" ? entry.name : null;
  const measuredBoard = entry.shelf === "boards" ? entry.name : null;
  const [machineName, setMachine] = useState(measuredMachine ?? page.machine);
  const [boardName, setBoard] = useState(measuredBoard ?? page.board);
  const [stationNumber, setStation] = useState<number | null>(null);
  const [code, setCode] = useState<string | null>(null);
  const machine = chosenEntry(machines, machineName, measuredMachine);
  const board = chosenEntry(boards, boardName, measuredBoard);
  const stations = (machine?.stations ?? []).filter(
    ({ tool }) => kind === null || tool.kind === kind,
  );
  const station = stations.find(({ number }) => number === stationNumber) ?? stations[0];
  const suitable = pieces.filter(({ kinds }) => kinds.includes(station?.tool.kind ?? ""));
  const piece = suitable.find((one) => one.code === code) ?? suitable[0];
  if (error !== null) {
    return (
      <Text c="var(--bad-ink)" role="alert">
        {errorText(error)}
      </Text>
    );
  }
  return (
    <section
      className={css.group}
      aria-label={translate("testPieces.measureWithATestPiece")}
      data-testid="test-pieces"
    >
      <Title order={2} fz={16} mb={10}>
        {translate("testPieces.stepChoose")}
      </Title>
      <div className={css.fields}>
        <Select
          label={translate("testPieces.machine")}
          data={machines.map(({ name, title }) => ({ value: name, label: title || name }))}
          value={machine?.name ?? null}
          allowDeselect={false}
          onChange={setMachine}
          data-testid="piece-machine"
        />
        <Select
          label={translate("testPieces.station")}
          data={stations.map(({ number, name }) => ({
            value: String(number),
            label: `${number} ${name}`,
          }))}
          value={station === undefined ? null : String(station.number)}
          allowDeselect={false}
          onChange={(value) => setStation(value === null ? null : Number(value))}
          data-testid="piece-station"
        />
        <Select
          label={translate("boardSelect.board")}
          data={boards.map(({ name, title }) => ({ value: name, label: title || name }))}
          value={board?.name ?? null}
          allowDeselect={false}
          searchable
          onChange={setBoard}
          data-testid="piece-board"
        />
        <Select
          label={translate("testPieces.testPiece")}
          data={suitable.map((one) => ({ value: one.code, label: messageText(one.name) }))}
          value={piece?.code ?? null}
          allowDeselect={false}
          onChange={setCode}
          data-testid="piece-code"
        />
      </div>
      {station === undefined || piece === undefined ? (
        <Text mt={10}>{translate("testPieces.noTool")}</Text>
      ) : (
        machine !== undefined &&
        board !== undefined && (
          <Steps
            key={`${machine.name} ${station.number} ${board.name} ${piece.code}`}
            piece={piece}
            bench={{ machine: machine.name, station: station.number, board: board.name }}
          />
        )
      )}
    </section>
  );
}

interface StepsProps {
  readonly piece: Parameters<typeof Measuring>[0]["piece"];
  readonly bench: Bench;
}

function Steps({ piece, bench }: StepsProps) {
  const [drawing, setDrawing] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const refusal = useRefusal("POST /api/v1/testpieces");
  const picture = useQuery({
    queryKey: ["testPiece", piece.code, bench],
    queryFn: ({ signal }) => testPieceService.picture(piece.code, bench, signal),
    retry: false,
  });
  const order = async () => {
    setDrawing(true);
    setFailure(null);
    try {
      const made = await testPieceService.draw(piece.code, bench);
      showDrawing(made.drawing.id);
      const { cut_depths, crease_depths } = made;
      const options = { ...DEFAULT_OPTIONS, cut_depths, crease_depths } as typeof DEFAULT_OPTIONS;
      useUiStore.getState().set({ machine: bench.machine, board: bench.board, options });
    } catch (reason) {
      setFailure(reason);
      setDrawing(false);
    }
  };
  if (picture.error !== null) {
    return (
      <Text mt={12} c="var(--bad-ink)" role="alert" data-testid="piece-fault">
        {errorText(picture.error)}
      </Text>
    );
  }
  return (
    <>
      <Text my={10} c="ink.2">
        {messageText(piece.description)}
      </Text>
      <PiecePicture svg={picture.data} name={messageText(piece.name)} />
      <Title order={2} fz={16} mt={22} mb={6}>
        {translate("testPieces.stepOrder")}
      </Title>
      <Text mb={8}>{translate("testPieces.orderedLikeAnyDrawing")}</Text>
      {failure instanceof Error && (
        <Text my={8} c="var(--bad-ink)" role="alert">
          {errorText(failure)}
        </Text>
      )}
      <Refusal reason={refusal} />
      <Group gap={8}>
        <Button
          loading={drawing}
          disabled={refusal !== null || picture.data === undefined}
          onClick={() => void order()}
          data-testid="piece-order"
        >
          {translate("testPieces.openTheOrder")}
        </Button>
      </Group>
      <Measuring piece={piece} bench={bench} />
    </>
  );
}
