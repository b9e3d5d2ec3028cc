/** Button that opens drawing files. */

import { Button } from "@mantine/core";
import { IconUpload } from "@tabler/icons-react";
import { useRef } from "react";
import { translate } from "../../language/translate";
import { uploadFiles } from "../../state/actions";
import { useFormats } from "../../state/queries";
import { useUiStore } from "../../state/store";

export function ChooseFile() {
  const input = useRef<HTMLInputElement>(null);
  const upload = useUiStore((ui) => ui.upload);
  const { data: formats } = useFormats();
  return (
    <>
      <input
        ref={input}
        type="file"
        accept={formats
          ?.filter((format) => format.available)
          .flatMap((format) => format.extensions)
          .join(",")}
        multiple
        hidden
        data-testid="file-input"
        onChange={(event) => {
          void uploadFiles([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = "";
        }}
      />
      <Button
        leftSection={<IconUpload size={16} aria-hidden />}
        loading={upload !== null}
        onClick={() => input.current?.click()}
        data-testid="choose-file"
      >
        {translate("drawingsPanel.openDrawingFiles")}
      </Button>
    </>
  );
}
