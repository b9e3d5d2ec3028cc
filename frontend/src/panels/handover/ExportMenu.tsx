/** Menu that downloads a drawing, a sheet or a compensated path in a format of other programs. */

import { Button, Menu } from "@mantine/core";
import { IconDownload } from "@tabler/icons-react";
import { EXPORT_FORMATS, type ExportFormat } from "../../api/drawings";
import { translate } from "../../language/translate";

interface Props {
  readonly label: string;
  readonly testId: string;
  /** Address of the file in a format. */
  urlOf(format: ExportFormat): string;
}

const TITLES: Readonly<Record<ExportFormat, string>> = {
  svg: translate("exportMenu.svg"),
  png: translate("exportMenu.png"),
  dxf: translate("exportMenu.dxf"),
  pdf: translate("exportMenu.pdf"),
};

export function ExportMenu({ label, testId, urlOf }: Props) {
  return (
    <Menu position="bottom-start" shadow="md" withinPortal>
      <Menu.Target>
        <Button
          size="xs"
          variant="subtle"
          color="gray"
          leftSection={<IconDownload size={15} aria-hidden />}
          data-testid={testId}
        >
          {label}
        </Button>
      </Menu.Target>
      <Menu.Dropdown>
        {EXPORT_FORMATS.map((format) => (
          <Menu.Item
            key={format}
            component="a"
            href={urlOf(format)}
            download
            data-testid={`${testId}-${format}`}
          >
            {TITLES[format]}
          </Menu.Item>
        ))}
      </Menu.Dropdown>
    </Menu>
  );
}
