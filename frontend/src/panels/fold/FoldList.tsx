/** The list of folds: each with its panels and its angle, so that the keyboard does all. */

import { NumberInput } from "@mantine/core";
import { useEffect, useRef, useState } from "react";
import type { Fold, Folding } from "../../api/folding";
import { translate } from "../../language/translate";
import css from "./fold.module.css";

interface Props {
  readonly folding: Folding;
  readonly angles: Readonly<Record<number, number>>;
  readonly chosen: number | null;
  onChoose(fold: number | null): void;
  onAngle(fold: number, angle: number): void;
}

export function FoldList({ folding, angles, chosen, onChoose, onAngle }: Props) {
  const rows = useRef<HTMLUListElement>(null);
  useEffect(() => {
    rows.current
      ?.querySelector(`[data-fold="${chosen}"]`)
      ?.scrollIntoView({ block: "nearest", behavior: "auto" });
  }, [chosen]);
  return (
    <ul ref={rows} className={css.folds} data-testid="folds">
      {folding.folds.map((fold) => (
        <li key={fold.number} data-fold={fold.number} data-chosen={fold.number === chosen}>
          <AngleInput
            fold={fold}
            angle={angles[fold.number] ?? fold.angle}
            onFocus={() => onChoose(fold.number)}
            onAngle={(angle) => onAngle(fold.number, angle)}
          />
        </li>
      ))}
    </ul>
  );
}

interface AngleProps {
  readonly fold: Fold;
  readonly angle: number;
  onFocus(): void;
  onAngle(angle: number): void;
}

function AngleInput({ fold, angle, onFocus, onAngle }: AngleProps) {
  // While a number is typed, such as "-" of "-90", it is a text.
  const [typed, setTyped] = useState<number | string>(angle);
  useEffect(() => setTyped(angle), [angle]);
  return (
    <NumberInput
      size="xs"
      label={translate("foldList.foldBetween", {
        fold: fold.number,
        parent: fold.parent,
        child: fold.child,
      })}
      description={describe(fold)}
      suffix="°"
      min={-180}
      max={180}
      step={5}
      disabled={fold.closes || !fold.straight}
      value={typed}
      onFocus={onFocus}
      onChange={(value) => {
        setTyped(value);
        if (typeof value === "number" && Math.abs(value) <= 180) onAngle(value);
      }}
    />
  );
}

function describe({ type, closes, straight, opening }: Fold): string {
  if (closes) return translate("foldList.closesHere");
  if (!straight) return translate("foldList.notStraight");
  return type === "v-groove"
    ? translate("foldList.groove", { opening: opening ?? 0 })
    : translate("foldList.crease");
}
