/** Layers and colours of the file: show, select, set line type. */

import { ActionIcon, Box } from "@mantine/core";
import { IconDots, IconEye, IconEyeOff } from "@tabler/icons-react";
import type { Drawing } from "../../api/drawings";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { retype } from "../../state/actions";
import { indexColour } from "../../state/drawing/colours";
import { layerKey, rowsOfLayer } from "../../state/drawing/rows";
import { useDrawing, useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { Figure, Name } from "../shared/parts";
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";
import { TypeMenu } from "./TypeMenu";

type Layer = Drawing["layers"][number];

export function LayersPanel() {
  const { data: drawing } = useDrawing();
  if (drawing === undefined) return null;
  return (
    <Section
      title={translate("layersPanel.layersInTheFile")}
      flush
      aside={<Figure>{drawing.layers.length}</Figure>}
    >
      <Box mah={300} style={{ overflow: "hidden auto" }}>
        {drawing.layers.map((layer) => (
          <Row key={layerKey(layer.name, layer.colour)} layer={layer} />
        ))}
      </Box>
    </Section>
  );
}

function Row({ layer }: { layer: Layer }) {
  const { data: edges } = useEdges();
  const key = layerKey(layer.name, layer.colour);
  const hidden = useUiStore((ui) => ui.hiddenLayers.has(key));
  const toggle = useUiStore((ui) => ui.toggleFileLayer);
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const rows = () => (edges === undefined ? [] : rowsOfLayer(edges, layer.name, layer.colour));
  return (
    <div className={css.row} data-off={hidden}>
      <button
        type="button"
        className={css.rowMain}
        title={translate("layersPanel.selectAllEdgesOnLayer", {
          name: layer.name,
          colour: layer.colour,
        })}
        onClick={() => selectEdges(rows())}
      >
        <span className={css.dot} style={{ background: indexColour(layer.colour) }} />
        <Name>{layer.name}</Name>
        <span style={{ display: "flex", gap: 4 }}>
          {layer.types.map((type) => (
            <Swatch key={type} type={type} />
          ))}
        </span>
        <Figure miw={30} ta="right" c="ink.2">
          {formatNumber(layer.edges)}
        </Figure>
      </button>
      <span style={{ display: "flex" }}>
        <TypeMenu
          label={translate("layersPanel.lineTypeOfLayer", { name: layer.name })}
          onChoose={(type) => void retype(rows(), type)}
        >
          <ActionIcon
            variant="subtle"
            color="gray"
            size="sm"
            disabled={refusal !== null}
            title={refusal ?? undefined}
            aria-label={translate("layersPanel.setTheLineTypeOf", { name: layer.name })}
          >
            <IconDots size={15} />
          </ActionIcon>
        </TypeMenu>
        <ActionIcon
          variant="subtle"
          color="gray"
          size="sm"
          aria-label={
            hidden
              ? translate("layersPanel.showLayer", { name: layer.name })
              : translate("layersPanel.hideLayer", { name: layer.name })
          }
          aria-pressed={!hidden}
          onClick={() => toggle(key)}
        >
          {hidden ? <IconEyeOff size={15} /> : <IconEye size={15} />}
        </ActionIcon>
      </span>
    </div>
  );
}
