/** How a router goes round corners: one type for all, and exceptions for single corners. */

import {
  Box,
  Button,
  CloseButton,
  Fieldset,
  Flex,
  Group,
  SegmentedControl,
  SimpleGrid,
  Slider,
  Stack,
} from "@mantine/core";
import { IconHandClick } from "@tabler/icons-react";
import { useId } from "react";
import type { CornerAt } from "../../api/jobs";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import {
  CORNER_TYPES,
  type CornerType,
  setCornerK,
  setCornerType,
} from "../../state/order/corners";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { CornerPicture } from "./CornerPicture";
import cornerCss from "./corners.module.css";

const TITLES: Readonly<Record<CornerType, string>> = {
  auto: translate("cornersForm.automatic"),
  B: translate("cornersForm.arcB"),
  C: translate("cornersForm.straightWithStopC"),
  D: translate("cornersForm.blendD"),
};

const DESCRIPTIONS: Readonly<Record<CornerType, string>> = {
  auto: translate("cornersForm.forEachCornerKnifetipChooses"),
  B: translate("cornersForm.theCentreOfTheTool"),
  C: translate("cornersForm.theCentreOfTheTool2"),
  D: translate("cornersForm.theCentreOfTheTool3"),
};

/** Label of the slider for the parameter k. */
const K_LABEL = translate("cornersForm.parameterKOfTheTool");

export function CornersForm() {
  const corners = useUiStore((ui) => ui.corners);
  const pickingCorners = useUiStore((ui) => ui.pickingCorners);
  const set = useUiStore((ui) => ui.set);
  const fit = useId();
  const hasSize = corners.type === "D" || corners.type === "auto";
  return (
    <Fieldset
      px={12}
      py={8}
      legend={translate("cornersForm.toolPathAtOuterCorners")}
      data-testid="corners"
    >
      <Stack gap={8}>
        <SimpleGrid cols={4} spacing={4}>
          {CORNER_TYPES.map((type) => (
            <button
              key={type}
              type="button"
              className={`${css.choice} ${cornerCss.cornerType}`}
              aria-pressed={corners.type === type}
              title={DESCRIPTIONS[type]}
              onClick={() => set({ corners: { ...corners, type } })}
              data-testid={`corner-${type}`}
            >
              <CornerPicture type={type} />
              {TITLES[type]}
            </button>
          ))}
        </SimpleGrid>
        <Note>{DESCRIPTIONS[corners.type]}</Note>
        {hasSize && (
          <SizeSlider
            label={K_LABEL}
            value={corners.k}
            onChange={(k) => set({ corners: { ...corners, k } })}
          />
        )}
        <Stack gap={4} fz={12} c="ink.2">
          <span id={fit}>{translate("cornersForm.whereTheToolIsToo")}</span>
          <SegmentedControl
            size="xs"
            fullWidth
            orientation="vertical"
            aria-labelledby={fit}
            data={[
              { value: "trim", label: translate("cornersForm.leaveThisPartUncut") },
              { value: "refuse", label: translate("cornersForm.doNotCreateAProgram") },
            ]}
            value={corners.interference}
            onChange={(choice) =>
              set({
                corners: { ...corners, interference: choice === "refuse" ? "refuse" : "trim" },
              })
            }
            data-testid="interference"
          />
        </Stack>
        <SingleCorners />
        {pickingCorners && <Note>{translate("cornersForm.inTheDrawingClickA")}</Note>}
        <Button
          size="xs"
          variant={pickingCorners ? "light" : "default"}
          leftSection={<IconHandClick size={15} aria-hidden />}
          aria-pressed={pickingCorners}
          onClick={() => set({ pickingCorners: !pickingCorners })}
          data-testid="pick-corner"
        >
          {pickingCorners
            ? translate("cornersForm.finishChoosingCorners")
            : translate("cornersForm.chooseThePathForIndividual")}
        </Button>
      </Stack>
    </Fieldset>
  );
}

const positionText = ({ x, y }: CornerAt): string =>
  translate("cornersForm.position", { x: formatFixed(x, 1), y: formatFixed(y, 1) });

/** The corners with a type of their own, one per row. */
function SingleCorners() {
  const corners = useUiStore((ui) => ui.corners);
  const set = useUiStore((ui) => ui.set);
  if (corners.at.length === 0) return null;
  return (
    <Flex component="ul" direction="column" gap={6} data-testid="single-corners">
      {corners.at.map((one, which) => (
        <li key={`${one.x} ${one.y}`}>
          <Group gap={8} justify="space-between" fz={12} c="ink.2">
            <span>{positionText(one)}</span>
            <SegmentedControl
              size="xs"
              data={CORNER_TYPES.map((type) => ({
                value: type,
                label: type === "auto" ? TITLES.auto : type,
              }))}
              value={one.type}
              onChange={(choice) => {
                const type = CORNER_TYPES.find((known) => known === choice);
                if (type !== undefined) set({ corners: setCornerType(corners, which, type) });
              }}
              aria-label={translate("cornersForm.toolPathAtTheCorner", { one: positionText(one) })}
            />
            <CloseButton
              size="sm"
              aria-label={translate("cornersForm.resetTheToolPathAt", { one: positionText(one) })}
              onClick={() => set({ corners: setCornerType(corners, which, null) })}
            />
          </Group>
          {one.type === "D" && (
            <SizeSlider
              label={K_LABEL}
              value={one.k ?? corners.k}
              onChange={(k) => set({ corners: setCornerK(corners, which, k) })}
            />
          )}
        </li>
      ))}
    </Flex>
  );
}

interface SizeSliderProps {
  label: string;
  value: number;
  onChange: (k: number) => void;
}

function SizeSlider({ label, value, onChange }: SizeSliderProps) {
  return (
    <Box fz={12} c="ink.2">
      <span>{label}</span>
      <Group gap={10}>
        <Slider
          flex={1}
          size="sm"
          min={0.05}
          max={0.95}
          step={0.05}
          value={value}
          label={null}
          thumbLabel={label}
          onChange={(k) => onChange(Number(k.toFixed(2)))}
        />
        {formatFixed(value, 2)}
      </Group>
    </Box>
  );
}
