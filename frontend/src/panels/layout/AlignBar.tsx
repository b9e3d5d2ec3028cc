/** Aligns the chosen drawings with the margins of the sheet, or with the first of them. */

import { ActionIcon, Tooltip } from "@mantine/core";
import {
  IconLayoutAlignBottom,
  IconLayoutAlignCenter,
  IconLayoutAlignLeft,
  IconLayoutAlignMiddle,
  IconLayoutAlignRight,
  IconLayoutAlignTop,
} from "@tabler/icons-react";
import { useRef } from "react";
import { translate } from "../../language/translate";
import { useRovingFocus } from "../shared/roving";
import css from "./layout.module.css";
import { ALIGNMENTS, type Alignment } from "./placing";

interface Props {
  readonly disabled: boolean;
  readonly onAlign: (alignment: Alignment) => void;
}

const LOOKS = {
  left: { label: translate("layoutEditor.left"), Icon: IconLayoutAlignLeft },
  right: { label: translate("layoutEditor.right"), Icon: IconLayoutAlignRight },
  below: { label: translate("layoutEditor.below"), Icon: IconLayoutAlignBottom },
  above: { label: translate("layoutEditor.above"), Icon: IconLayoutAlignTop },
  centreX: { label: translate("layoutEditor.centreX"), Icon: IconLayoutAlignCenter },
  centreY: { label: translate("layoutEditor.centreY"), Icon: IconLayoutAlignMiddle },
} as const;

export function AlignBar({ disabled, onAlign }: Props) {
  const bar = useRef<HTMLDivElement>(null);
  useRovingFocus(bar);
  return (
    <div
      ref={bar}
      className={css.align}
      role="toolbar"
      aria-label={translate("layoutEditor.align")}
    >
      {ALIGNMENTS.map((alignment) => {
        const { label, Icon } = LOOKS[alignment];
        return (
          <Tooltip key={alignment} label={label}>
            <ActionIcon
              variant="default"
              size="lg"
              disabled={disabled}
              aria-label={label}
              onClick={() => onAlign(alignment)}
              data-testid={`align-${alignment}`}
            >
              <Icon size={18} />
            </ActionIcon>
          </Tooltip>
        );
      })}
    </div>
  );
}
