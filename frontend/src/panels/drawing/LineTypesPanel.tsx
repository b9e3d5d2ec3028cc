/** Legend of line types: length, number of edges and visibility. */

import { ActionIcon, Skeleton } from "@mantine/core";
import { IconEye, IconEyeOff } from "@tabler/icons-react";
import type { LineType } from "../../geometry/records";
import { formatNumber, insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { LEGEND, LINE_STYLES } from "../../state/drawing/palette";
import { rowsOfType } from "../../state/drawing/rows";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { useDrawing, useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { Figure, Name } from "../shared/parts";
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";

export function LineTypesPanel() {
  const { data: drawing } = useDrawing();
  const counts = new Map(drawing?.counts.map((count) => [count.type, count]));
  return (
    <Section title={translate("lineTypesPanel.lineTypes")} flush>
      {drawing === undefined && <Skeleton height={96} radius={8} />}
      <div data-testid="legend">
        {LEGEND.map((type) => {
          const count = counts.get(type);
          if (count === undefined || count.edges === 0) return null;
          return <Row key={type} type={type} edges={count.edges} length={count.length} />;
        })}
      </div>
    </Section>
  );
}

function Row({ type, edges, length }: { type: LineType; edges: number; length: number }) {
  const hidden = useUiStore((ui) => ui.hiddenTypes.has(type));
  const toggle = useUiStore((ui) => ui.toggleType);
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const { data: columns } = useEdges();
  const formatLength = useFormatLength();
  const { title } = LINE_STYLES[type];
  return (
    <div className={css.row} data-off={hidden} data-testid={`legend-${type}`}>
      <button
        type="button"
        className={css.rowMain}
        title={translate("lineTypesPanel.selectAllEdges", { title: insideSentence(title) })}
        onClick={() => columns && selectEdges(rowsOfType(columns, type))}
      >
        <Swatch type={type} />
        <Name>{title}</Name>
        <Figure>{formatLength(length)}</Figure>
        <Figure miw={30} ta="right" c="ink.2">
          {formatNumber(edges)}
        </Figure>
      </button>
      <ActionIcon
        variant="subtle"
        color="gray"
        size="sm"
        aria-label={
          hidden
            ? translate("lineTypesPanel.showEdges", { title: insideSentence(title) })
            : translate("lineTypesPanel.hideEdges", { title: insideSentence(title) })
        }
        aria-pressed={!hidden}
        onClick={() => toggle(type)}
      >
        {hidden ? <IconEyeOff size={15} /> : <IconEye size={15} />}
      </ActionIcon>
    </div>
  );
}
