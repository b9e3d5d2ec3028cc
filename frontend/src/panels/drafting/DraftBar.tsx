/** What the drawing tool waits for, its figures, and fields for a point given by numbers. */

import { Button, CloseButton, Group, NativeSelect, NumberInput, Text } from "@mantine/core";
import { useState } from "react";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { addEdits } from "../../state/actions";
import { useDimensions } from "../../state/drafting/dimensions";
import { type DraftTool, editsOf, isAreaKind, useDrafting } from "../../state/drafting/drafting";
import { measure } from "../../state/drafting/measure";
import type { EditedType } from "../../state/drawing/edits";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../../state/drawing/palette";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import overlayCss from "../drawing/overlay.module.css";
import css from "./drafting.module.css";
import { choosePoint } from "./usePickedPoints";

const FIRST: Readonly<Record<DraftTool, string>> = {
  measure: translate("draftBar.chooseTheFirstPoint"),
  line: translate("draftBar.chooseTheStartOfTheLine"),
  circle: translate("draftBar.chooseTheCentre"),
  move: translate("draftBar.chooseTheEndToMove"),
};
const SECOND: Readonly<Record<DraftTool, string>> = {
  measure: translate("draftBar.chooseTheSecondPoint"),
  line: translate("draftBar.chooseTheEndOfTheLine"),
  circle: translate("draftBar.chooseAPointOnTheCircle"),
  move: translate("draftBar.chooseItsNewPlace"),
};

const TYPES = ASSIGNABLE_TYPES.filter((type): type is EditedType => type !== "ignored").map(
  (type) => ({ value: type, label: LINE_STYLES[type].title }),
);

export function DraftBar() {
  const { tool, first, second, type, setType, choose } = useDrafting();
  if (tool === null || isAreaKind(tool)) return null;
  const draws = tool === "line" || tool === "circle";
  return (
    <Group
      className={`${overlayCss.float} ${css.bar}`}
      role="group"
      aria-label={translate("draftBar.drawingTool")}
      gap={10}
      data-testid="draft"
    >
      <Text fz={12.5} role="status" maw={280}>
        {first !== null && second !== null ? (
          <Figures from={first} to={second} />
        ) : (
          (first === null ? FIRST : SECOND)[tool]
        )}
      </Text>
      {draws && (
        <NativeSelect
          size="xs"
          aria-label={translate("draftBar.lineTypeOfTheNewEdge")}
          data={TYPES}
          value={type}
          onChange={(event) => setType(event.currentTarget.value as EditedType)}
        />
      )}
      <PointFields />
      {tool === "measure" && first !== null && second !== null && (
        <KeepButton from={first} to={second} />
      )}
      <CloseButton
        size="sm"
        aria-label={translate("draftBar.leaveTheTool")}
        onClick={() => choose(null)}
      />
    </Group>
  );
}

function Figures({ from, to }: { from: Parameters<typeof measure>[0]; to: typeof from }) {
  const { distance, dx, dy, angle } = measure(from, to);
  return translate("draftBar.measured", {
    distance: formatFixed(distance, 2),
    dx: formatFixed(dx, 2),
    dy: formatFixed(dy, 2),
    angle: formatFixed(angle, 1),
  });
}

/** Keeps a measurement as a dimension of the view. */
function KeepButton({ from, to }: { from: Parameters<typeof measure>[0]; to: typeof from }) {
  const drawing = useUiStore((ui) => ui.drawing);
  const keep = useDimensions((dimensions) => dimensions.keep);
  const cancel = useDrafting((draft) => draft.cancel);
  return (
    <Button
      size="compact-xs"
      onClick={() => {
        if (drawing === null) return;
        keep(drawing, { from: { x: from.x, y: from.y }, to: { x: to.x, y: to.y } });
        cancel();
      }}
      data-testid="keep-dimension"
    >
      {translate("draftBar.keepTheDimension")}
    </Button>
  );
}

/** X and Y of a point, for the keyboard and for exact places. */
function PointFields() {
  const [x, setX] = useState<number | string>("");
  const [y, setY] = useState<number | string>("");
  const { data: edges } = useEdges();
  const complete = typeof x === "number" && typeof y === "number";
  const choose = () => {
    if (!complete || edges === undefined) return;
    const done = choosePoint({ x, y, kind: "free" });
    if (done === null) return;
    const { selection } = useUiStore.getState();
    void addEdits(editsOf(done.tool, done.points, edges, { type: done.type, selection }));
  };
  return (
    <Group
      component="form"
      gap={6}
      wrap="nowrap"
      onSubmit={(event) => {
        event.preventDefault();
        choose();
      }}
    >
      {(
        [
          ["X", x, setX],
          ["Y", y, setY],
        ] as const
      ).map(([axis, value, set]) => (
        <NumberInput
          key={axis}
          size="xs"
          w={84}
          hideControls
          aria-label={`${axis} (mm)`}
          placeholder={`${axis} (mm)`}
          value={value}
          onChange={set}
        />
      ))}
      <Button
        size="compact-xs"
        variant="default"
        type="submit"
        disabled={!complete || edges === undefined}
      >
        {translate("draftBar.setPoint")}
      </Button>
    </Group>
  );
}
