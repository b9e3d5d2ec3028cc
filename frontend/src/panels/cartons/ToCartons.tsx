/** Link to the carton styles, from which a drawing is made by its dimensions. */

import { Button } from "@mantine/core";
import { translate } from "../../language/translate";

export function ToCartons() {
  return (
    <Button component="a" href="#/cartons" variant="default" data-testid="to-cartons">
      {translate("cartonPage.cartonsFromAStandard")}
    </Button>
  );
}
