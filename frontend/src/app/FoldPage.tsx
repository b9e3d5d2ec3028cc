/** The page of a folded drawing: the board in 3D, its folds with their angles, and its faults. */

import "../messages/load";
import { Button, Loader, NumberInput, Select, Slider } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useCallback, useMemo, useState } from "react";
import { type FoldFinding, foldingService } from "../api/folding";
import { translate } from "../language/translate";
import { errorText } from "../messages/translateMessage";
import { FoldFindings } from "../panels/fold/FoldFindings";
import { FoldList } from "../panels/fold/FoldList";
import css from "../panels/fold/fold.module.css";
import { type FoldChoices, foldingQuery, foldOfPanel, wantedOf } from "../state/fold/folding";
import { queries, useBoards } from "../state/queries";
import { decodedPart } from "../state/routes";
import { useUiStore } from "../state/store";
import type { FoldViewer } from "../viewer/fold/foldViewer";
import { FoldCanvas } from "./FoldCanvas";

type SideUp = FoldChoices["sideUp"];

/** First value of the slider (%). */
const FIRST = 100;

export function FoldPage({ drawing }: { drawing: string }) {
  const id = decodedPart(drawing);
  const { data: shown } = useQuery(queries.drawing(id));
  const { data: boards = [] } = useBoards();
  const ordered = useUiStore((ui) => ui.board);
  const [picked, setBoard] = useState<string | null>(null);
  const board = picked ?? ordered ?? boards[0]?.name ?? "";
  const [sideUp, setSideUp] = useState<SideUp>("outside");
  const [opening, setOpening] = useState<number | null>(null);
  const [angles, setAngles] = useState<FoldChoices["angles"]>({});
  const [percent, setPercent] = useState(FIRST);
  const [chosen, setChosen] = useState<ReadonlySet<number>>(new Set());
  const [viewer, setViewer] = useState<FoldViewer | null>(null);
  const [fault, setFault] = useState("");
  const choices = { board, sideUp, opening, angles };
  const { data: folding, error } = useQuery({
    ...foldingQuery(id, choices),
    enabled: board !== "",
  });
  const angleOf = useCallback(
    (fold: number) => angles[fold] ?? folding?.folds[fold - 1]?.angle ?? 0,
    [angles, folding],
  );
  const chosenFold = useMemo(() => {
    const [panel] = chosen;
    if (folding === undefined || panel === undefined || chosen.size > 1) return null;
    return foldOfPanel(folding, panel)?.number ?? null;
  }, [folding, chosen]);
  const chooseFold = (fold: number | null) => {
    const child = folding?.folds[(fold ?? 0) - 1]?.child;
    setChosen(new Set(child === undefined ? [] : [child - 1]));
  };
  const save = async (name: string, make: () => Promise<Blob | null | undefined>) => {
    setFault("");
    try {
      const file = await make();
      if (file != null) download(file, name);
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
    }
  };
  const title = shown?.name ?? id;
  const message = fault || (error === null ? "" : errorText(error));
  return (
    <div className={css.page} data-testid="fold-page">
      <main className={css.stage}>
        {folding === undefined ? (
          error === null && (
            <Loader pos="absolute" inset={0} m="auto" aria-label={translate("foldPage.folding")} />
          )
        ) : (
          <>
            <FoldCanvas
              folding={folding}
              fraction={percent / 100}
              outsideUp={sideUp === "outside"}
              angleOf={angleOf}
              chosen={chosen}
              onPick={(panel) => setChosen(new Set(panel === null ? [] : [panel]))}
              onViewer={setViewer}
            />
            <div className={css.slider}>
              <Slider
                value={percent}
                onChange={setPercent}
                label={(value) => `${value} %`}
                marks={[0, 50, 100].map((value) => ({ value, label: `${value} %` }))}
                thumbLabel={translate("foldPage.foldedBy")}
                data-testid="fold-slider"
              />
            </div>
          </>
        )}
      </main>
      <aside className={css.side} aria-label={translate("foldPage.folds")}>
        <h1>{translate("foldPage.folded", { title })}</h1>
        <Button component="a" href={`#/drawings/${encodeURIComponent(id)}/lines`} variant="default">
          {translate("foldPage.backToTheDrawing")}
        </Button>
        {message !== "" && (
          <p role="alert" style={{ color: "var(--bad-ink)" }} data-testid="fold-error">
            {message}
          </p>
        )}
        <Select
          mt={12}
          label={translate("foldPage.board")}
          data={boards.map(({ name, title }) => ({ value: name, label: title || name }))}
          value={board}
          allowDeselect={false}
          onChange={setBoard}
        />
        <Select
          mt={8}
          label={translate("foldPage.sideUp")}
          data={[
            { value: "outside", label: translate("foldPage.outside") },
            { value: "inside", label: translate("foldPage.inside") },
          ]}
          value={sideUp}
          allowDeselect={false}
          onChange={(value) => setSideUp(value as SideUp)}
        />
        {folding?.folds.some(({ opening }) => opening !== null) && (
          <NumberInput
            mt={8}
            label={translate("foldPage.opening")}
            suffix="°"
            min={1}
            max={179}
            value={opening ?? ""}
            onChange={(value) => setOpening(typeof value === "number" ? value : null)}
          />
        )}
        <div className={css.row}>
          <Button variant="default" size="xs" onClick={() => viewer?.fit()}>
            {translate("foldPage.showAll")}
          </Button>
          <Button
            variant="default"
            size="xs"
            disabled={viewer === null}
            onClick={() => void save(`${title}.png`, async () => viewer?.picture())}
          >
            {translate("foldPage.savePicture")}
          </Button>
          <Button
            variant="default"
            size="xs"
            disabled={folding === undefined}
            onClick={() =>
              void save(`${title}.glb`, () =>
                foldingService.file(id, { ...wantedOf(choices), fraction: percent / 100 }),
              )
            }
          >
            {translate("foldPage.saveGltf")}
          </Button>
        </div>
        {folding !== undefined && (
          <>
            <h2>{translate("foldPage.faults")}</h2>
            {folding.panels.length === 0 ? (
              <p className={css.sound}>{translate("foldPage.noBlank")}</p>
            ) : (
              <FoldFindings
                findings={folding.findings}
                onChoose={({ panels }: FoldFinding) =>
                  setChosen(new Set(panels.map((panel) => panel - 1)))
                }
              />
            )}
            <h2>{translate("foldPage.folds")}</h2>
            <FoldList
              folding={folding}
              angles={angles}
              chosen={chosenFold}
              onChoose={chooseFold}
              onAngle={(fold, angle) => setAngles({ ...angles, [fold]: angle })}
            />
          </>
        )}
      </aside>
    </div>
  );
}

function download(file: Blob, name: string): void {
  const url = URL.createObjectURL(file);
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  URL.revokeObjectURL(url);
}
