/** The picture of a test piece, with arrows for what is measured. */

import { Loader } from "@mantine/core";
import { translate } from "../../../language/translate";
import css from "./testpieces.module.css";

interface Props {
  /** SVG of the server; undefined while it is fetched. */
  readonly svg: string | undefined;
  readonly name: string;
}

export function PiecePicture({ svg, name }: Props) {
  return (
    <figure className={css.picture}>
      {svg === undefined ? (
        <Loader />
      ) : (
        <img
          src={`data:image/svg+xml,${encodeURIComponent(svg)}`}
          alt={translate("testPieces.pictureOf", { name })}
          data-testid="piece-picture"
        />
      )}
    </figure>
  );
}
