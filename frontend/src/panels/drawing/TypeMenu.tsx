/** A menu of line types. */

import { Kbd, Menu } from "@mantine/core";
import { IconArrowBackUp } from "@tabler/icons-react";
import type { ReactNode } from "react";
import type { LineType } from "../../geometry/records";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../../state/drawing/palette";
import { USE_PROFILE_TYPE } from "../shared/labels";
import { Swatch } from "../shared/Swatch";

interface Props {
  /** null: reset to the profile */
  onChoose: (type: LineType | null) => void;
  label: string;
  children: ReactNode;
}

export function TypeMenu({ onChoose, label, children }: Props) {
  return (
    <Menu position="bottom-end" shadow="lg" width={250}>
      <Menu.Target>{children}</Menu.Target>
      <Menu.Dropdown aria-label={label}>
        <Menu.Label>{label}</Menu.Label>
        {ASSIGNABLE_TYPES.map((type) => (
          <Menu.Item
            key={type}
            leftSection={<Swatch type={type} />}
            rightSection={<Kbd>{LINE_STYLES[type].key}</Kbd>}
            onClick={() => onChoose(type)}
          >
            {LINE_STYLES[type].title}
          </Menu.Item>
        ))}
        <Menu.Divider />
        <Menu.Item leftSection={<IconArrowBackUp size={16} />} onClick={() => onChoose(null)}>
          {USE_PROFILE_TYPE}
        </Menu.Item>
      </Menu.Dropdown>
    </Menu>
  );
}
