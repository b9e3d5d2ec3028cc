/** Shown while there are no drawings: how to open one, and three samples to try. */

import { Group, Text, Title } from "@mantine/core";
import { translate } from "../../language/translate";
import { uploadFiles } from "../../state/actions";
import { notifyError } from "../../state/notifications";
import { Permitted } from "../accounts/Permitted";
import { ToCartons } from "../cartons/ToCartons";
import { ChooseFile } from "./ChooseFile";
import css from "./work.module.css";

/** Files of the samples and of their pictures, which `frontend/samples.py` writes. */
const SAMPLES = [
  { name: "tuck-end-carton", title: translate("welcome.tuckEndCarton") },
  { name: "corrugated-tray", title: translate("welcome.corrugatedTray") },
  { name: "rigid-box-blank", title: translate("welcome.rigidBox") },
];

/** Open a sample as a file that the user has dropped. */
async function openSample(name: string): Promise<void> {
  try {
    const answer = await fetch(`samples/${name}.dxf`);
    if (!answer.ok) throw new Error(answer.statusText);
    await uploadFiles([new File([await answer.blob()], `${name}.dxf`)]);
  } catch (cause) {
    notifyError(cause);
  }
}

export function Welcome() {
  return (
    <div className={css.welcome} data-testid="welcome">
      <Title order={1} fz={23}>
        {translate("welcome.dropADielineFileHere")}
      </Title>
      <Text my={12} c="ink.2" fz={14} lh={1.55}>
        {translate("welcome.dxfSvgCf2PdfHpgl")}
      </Text>
      <Permitted request="POST /api/v1/drawings">
        <Group gap={10} justify="center">
          <ChooseFile />
          <ToCartons />
        </Group>
        <Text mt={28} c="ink.2">
          {translate("welcome.orTryASample")}
        </Text>
        <div className={css.samples}>
          {SAMPLES.map(({ name, title }) => (
            <button
              key={name}
              type="button"
              className={css.sample}
              onClick={() => void openSample(name)}
              data-testid={`sample-${name}`}
            >
              <img src={`samples/${name}.svg`} alt="" />
              {title}
            </button>
          ))}
        </div>
      </Permitted>
    </div>
  );
}
