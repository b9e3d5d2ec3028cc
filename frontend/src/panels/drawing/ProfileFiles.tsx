/** Buttons that export, import and delete a profile. */

import { ActionIcon, Tooltip } from "@mantine/core";
import { IconDownload, IconTrash, IconUpload } from "@tabler/icons-react";
import { useRef } from "react";
import { libraryService, type Profile } from "../../api/library";
import { translate } from "../../language/translate";
import { deleteProfile, importProfile, showSaved } from "../../state/drawing/profiles";
import { useUiStore } from "../../state/store";

export function ProfileFiles({ profile }: { profile: Profile }) {
  const input = useRef<HTMLInputElement>(null);
  const set = useUiStore((ui) => ui.set);
  return (
    <span style={{ display: "flex" }}>
      <Tooltip label={translate("profileFiles.downloadThisProfileAsA")}>
        <ActionIcon
          component="a"
          href={libraryService.profileUrl(profile.name)}
          download={`${profile.name}.toml`}
          variant="subtle"
          color="gray"
          aria-label={translate("profileFiles.downloadThisProfileAsA")}
          data-testid="export-profile"
        >
          <IconDownload size={16} />
        </ActionIcon>
      </Tooltip>
      <Tooltip label={translate("profileFiles.importAProfileFromA")}>
        <ActionIcon
          variant="subtle"
          color="gray"
          aria-label={translate("profileFiles.importAProfileFromA")}
          onClick={() => input.current?.click()}
        >
          <IconUpload size={16} />
        </ActionIcon>
      </Tooltip>
      <input
        ref={input}
        type="file"
        accept=".toml"
        hidden
        data-testid="import-profile"
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          event.currentTarget.value = "";
          if (file !== undefined)
            void importProfile(file).then((name) => name !== null && showSaved(name, profile.name));
        }}
      />
      {!profile.shipped && (
        <Tooltip label={translate("profileFiles.deleteThisProfile")}>
          <ActionIcon
            variant="subtle"
            color="gray"
            aria-label={translate("profileFiles.deleteThisProfile")}
            data-testid="delete-profile"
            onClick={() => {
              set({ editedProfile: null });
              void deleteProfile(profile);
            }}
          >
            <IconTrash size={16} />
          </ActionIcon>
        </Tooltip>
      )}
    </span>
  );
}
