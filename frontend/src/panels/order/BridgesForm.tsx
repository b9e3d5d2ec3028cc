/** Bridges that hold a part: placed by clicks on its outline, each with a width of its own. */

import {
  Button,
  CloseButton,
  Fieldset,
  Flex,
  Group,
  NumberInput,
  Stack,
  Text,
} from "@mantine/core";
import { IconHandClick } from "@tabler/icons-react";
import { useEffect } from "react";
import { formatFixed, formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import {
  type Bridge,
  distanceAlong,
  useBridgePicking,
  WIDTH,
  withBridgeWidth,
  withoutBridge,
} from "../../state/order/bridges";
import { useBoards, useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Note } from "../shared/parts";
import cornerCss from "./corners.module.css";

export function BridgesForm() {
  const { active, width } = useBridgePicking();
  const bridges = useUiStore((ui) => ui.options.bridges);
  const pickingCorners = useUiStore((ui) => ui.pickingCorners);
  const set = useUiStore((ui) => ui.set);
  const drawing = useUiStore((ui) => ui.drawing);
  // A click means one thing, and only while this form is open.
  useEffect(() => {
    if (pickingCorners) useBridgePicking.setState({ active: false });
  }, [pickingCorners]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another drawing ends it, too
  useEffect(() => () => useBridgePicking.setState({ active: false }), [drawing]);
  return (
    <Fieldset px={12} py={8} legend={translate("bridges.bridges")} data-testid="bridges">
      <Stack gap={8}>
        <Group gap={10} wrap="nowrap" align="flex-start">
          <BridgePicture />
          <Note>{bridges.length === 0 ? <OfBoard /> : translate("bridges.onlyThese")}</Note>
        </Group>
        <BridgeList />
        {active && <Note>{translate("bridges.clickTheOutline")}</Note>}
        <Group gap={8} align="flex-end" wrap="nowrap">
          <WidthInput
            label={translate("bridges.widthOfTheNext")}
            value={width}
            onChange={(next) => useBridgePicking.setState({ width: next })}
            testId="next-bridge-width"
          />
          <Button
            size="xs"
            variant={active ? "light" : "default"}
            leftSection={<IconHandClick size={15} aria-hidden />}
            aria-pressed={active}
            onClick={() => {
              set({ pickingCorners: false });
              useBridgePicking.setState({ active: !active });
            }}
            data-testid="pick-bridge"
          >
            {active ? translate("bridges.finish") : translate("bridges.place")}
          </Button>
        </Group>
      </Stack>
    </Fieldset>
  );
}

/** The bridges that the board requires where none is placed. */
function OfBoard() {
  const { data: boards } = useBoards();
  const name = useUiStore((ui) => ui.board);
  const board = boards?.find((one) => one.name === name);
  if (board === undefined) return translate("bridges.byTheBoard");
  return board.bridge_width > 0 && board.bridge_spacing > 0
    ? translate("bridges.requiredByTheBoard", {
        width: formatNumber(board.bridge_width),
        spacing: formatNumber(board.bridge_spacing),
      })
    : translate("bridges.noneByTheBoard");
}

function BridgeList() {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const { data: edges } = useEdges();
  const change = (bridges: Bridge[]) => set({ options: { ...options, bridges } });
  if (options.bridges.length === 0 || edges === undefined) return null;
  return (
    <Flex
      component="ol"
      direction="column"
      gap={4}
      mah={220}
      style={{ overflow: "hidden auto" }}
      data-testid="bridge-list"
    >
      {options.bridges.map((bridge, which) => {
        const [edge = 0] = bridge.edges;
        const place = translate("bridges.at", {
          edge,
          place: formatFixed(distanceAlong(bridge, edges), 1),
        });
        return (
          <li key={`${edge} ${bridge.at}`}>
            <Group gap={8} wrap="nowrap" justify="space-between">
              <Button
                size="compact-xs"
                variant="subtle"
                color="gray"
                onClick={() => selectEdges(bridge.edges)}
              >
                <Text span fz={12}>
                  {place}
                </Text>
              </Button>
              <WidthInput
                ariaLabel={translate("bridges.widthOf", { place })}
                value={bridge.width}
                onChange={(width) => change(withBridgeWidth(options.bridges, which, width))}
                testId="bridge-width"
              />
              <CloseButton
                size="sm"
                aria-label={translate("edgeOption.remove", { subject: place })}
                onClick={() => change(withoutBridge(options.bridges, which))}
              />
            </Group>
          </li>
        );
      })}
    </Flex>
  );
}

interface WidthInputProps {
  label?: string;
  ariaLabel?: string;
  value: number;
  onChange: (width: number) => void;
  testId: string;
}

function WidthInput({ label, ariaLabel, value, onChange, testId }: WidthInputProps) {
  return (
    <NumberInput
      size="xs"
      w={104}
      {...(label === undefined ? { "aria-label": ariaLabel } : { label })}
      suffix=" mm"
      min={WIDTH.min}
      max={WIDTH.max}
      step={WIDTH.step}
      decimalScale={2}
      clampBehavior="strict"
      value={value}
      onChange={(typed) => Number(typed) >= WIDTH.min && onChange(Number(typed))}
      data-testid={testId}
    />
  );
}

/** A part held by a bridge between two cuts. */
function BridgePicture() {
  return (
    <svg viewBox="0 0 56 44" width="56" height="44" style={{ flex: "none" }} aria-hidden="true">
      <path d="M0 22H56V44H0Z" className={cornerCss.cornerPart} />
      <path d="M2 22H22M34 22H54" className={cornerCss.cornerPath} />
      <path d="M22 17V12M34 17V12M22 14.5H34" className={cornerCss.cornerPath} data-faint />
    </svg>
  );
}
