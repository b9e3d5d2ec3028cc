/** Computes the deflection of a cutter in a board from points measured on a test cut. */

import { Box, Button, Group, NumberInput, Select, SimpleGrid, Text } from "@mantine/core";
import { useState } from "react";
import { type Calibration, type CalibrationOrder, libraryService } from "../../api/library";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { useMachines } from "../../state/queries";
import css from "./library.module.css";

interface Props {
  readonly board: string;
  /** Takes the deflection over into the form of the board, by the name of the station. */
  readonly onUse: (tool: string, deflection: { x: number; y: number }) => void;
}

interface Point {
  readonly azimuth: number | "";
  readonly dx: number | "";
  readonly dy: number | "";
}

const COLUMNS = [
  { key: "azimuth", label: translate("calibrationForm.directionOfTravel") },
  { key: "dx", label: translate("calibrationForm.offsetInXMm") },
  { key: "dy", label: translate("calibrationForm.offsetInYMm") },
] as const;
/** Edges along X, at 45° and along Y. */
const FIRST: readonly Point[] = [0, 45, 90].map((azimuth) => ({ azimuth, dx: "", dy: "" }));

export function CalibrationForm({ board, onUse }: Props) {
  const { data: machines = [] } = useMachines();
  const [place, setPlace] = useState<string | null>(null);
  const [side, setSide] = useState<CalibrationOrder["side"]>("left");
  const [points, setPoints] = useState<readonly Point[]>(FIRST);
  const [result, setResult] = useState<Calibration | null>(null);
  const [failure, setFailure] = useState("");
  // Only cutters that turn about their axis are pushed aside by a force that does not turn.
  const cutters = machines.flatMap((machine) =>
    machine.stations
      .filter(({ tool }) => tool.kind === "cutter")
      .map(({ name, number }) => ({
        value: `${machine.name} ${number}`,
        label: `${name}, ${machine.title || machine.name}`,
        machine: machine.name,
        tool: name,
      })),
  );
  const chosen = cutters.find(({ value }) => value === place) ?? cutters[0];
  const given = points.filter(({ dx, dy }) => dx !== "" || dy !== "");
  const set = (at: number, key: keyof Point, value: number | "") => {
    setResult(null);
    setPoints(points.map((point, row) => (row === at ? { ...point, [key]: value } : point)));
  };
  const compute = async () => {
    if (chosen === undefined) return;
    setFailure("");
    setResult(null);
    const measured = given.map(({ azimuth, dx, dy }) => ({
      azimuth: Number(azimuth),
      dx: Number(dx),
      dy: Number(dy),
    }));
    try {
      const { machine, tool } = chosen;
      setResult(await libraryService.calibrate(board, { machine, tool, side, points: measured }));
    } catch (error) {
      setFailure(error instanceof Error ? errorText(error) : String(error));
    }
  };
  if (chosen === undefined) {
    return <p>{translate("calibrationForm.noMachineHasACutter")}</p>;
  }
  return (
    <Box component="details" mt={16} data-testid="calibration">
      <Text component="summary" py={8} c="ink.0" fw={600}>
        {translate("calibrationForm.computeTheDeflectionFromA")}
      </Text>
      <p>{translate("calibrationForm.cutAContourWithoutCompensation")}</p>
      <div className={css.fields}>
        <Select
          label={translate("calibrationForm.cutter")}
          data={cutters.map(({ value, label }) => ({ value, label }))}
          value={chosen.value}
          allowDeselect={false}
          onChange={setPlace}
          data-testid="calibration-cutter"
        />
        <Select
          label={translate("calibrationForm.sideOfTheContourOn")}
          data={[
            { value: "left", label: translate("calibrationForm.leftAsInProgramsOf") },
            { value: "right", label: translate("calibrationForm.right") },
          ]}
          value={side}
          allowDeselect={false}
          onChange={(value) => value !== null && setSide(value as CalibrationOrder["side"])}
        />
      </div>
      {points.map((point, at) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a point has no other identity
        <SimpleGrid cols={3} spacing={8} maw={560} mt={8} key={at}>
          {COLUMNS.map(({ key, label }) => (
            <NumberInput
              key={key}
              label={label}
              aria-label={translate("calibrationForm.ofPoint", { label, at: at + 1 })}
              value={point[key]}
              onChange={(value) => set(at, key, typeof value === "number" ? value : "")}
              data-testid={`${key}-${at}`}
            />
          ))}
        </SimpleGrid>
      ))}
      <Group gap={8} mt={8} align="flex-end">
        <Button
          variant="default"
          onClick={() => setPoints([...points, { azimuth: "", dx: "", dy: "" }])}
        >
          {translate("calibrationForm.addPoint")}
        </Button>
        <Button disabled={given.length === 0} onClick={() => void compute()} data-testid="compute">
          {translate("calibrationForm.compute")}
        </Button>
      </Group>
      {failure !== "" && (
        <Text my={8} c="var(--bad-ink)" role="alert">
          {failure}
        </Text>
      )}
      {result !== null && (
        <Group gap={8} mt={8} align="flex-end" role="status" data-testid="calibration-result">
          <span>
            {translate("calibrationForm.mmInXMmIn", {
              tool: result.tool,
              x: formatFixed(result.x, 4),
              y: formatFixed(result.y, 4),
              residual: formatFixed(result.residual, 4),
            })}
          </span>
          <Button
            onClick={() => onUse(result.tool, { x: result.x, y: result.y })}
            data-testid="use-deflection"
          >
            {translate("calibrationForm.useTheseValues")}
          </Button>
        </Group>
      )}
    </Box>
  );
}
