/** A dialog. Its window is fetched when it is first opened: the start page does without it. */

import type { ModalProps } from "@mantine/core";
import { lazy, Suspense, useState } from "react";

const DialogWindow = lazy(() =>
  import("./DialogWindow").then((module) => ({ default: module.DialogWindow })),
);

export function Dialog(props: ModalProps) {
  const [wanted, setWanted] = useState(props.opened);
  if (props.opened && !wanted) setWanted(true);
  if (!wanted) return null;
  return (
    <Suspense fallback={null}>
      <DialogWindow {...props} />
    </Suspense>
  );
}
