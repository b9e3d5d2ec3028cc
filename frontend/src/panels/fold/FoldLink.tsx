/** Link to the folded drawing. */

import { Button } from "@mantine/core";
import { IconBox } from "@tabler/icons-react";
import { translate } from "../../language/translate";

export function FoldLink({ drawing }: { drawing: string }) {
  return (
    <Button
      component="a"
      href={`#/drawings/${encodeURIComponent(drawing)}/fold`}
      variant="default"
      size="xs"
      leftSection={<IconBox size={15} aria-hidden />}
      data-testid="open-fold"
    >
      {translate("documentPanel.foldIn3D")}
    </Button>
  );
}
