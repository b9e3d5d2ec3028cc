/** Choice of the language of the page. */

import { ActionIcon, Menu, Tooltip } from "@mantine/core";
import { IconCheck, IconLanguage } from "@tabler/icons-react";
import { changeLanguage, LANGUAGES, type Language, language } from "../../language/language";
import { translate } from "../../language/translate";

export function LanguageMenu() {
  const label = translate("languageMenu.language");
  return (
    <Menu position="bottom-end" shadow="md" withinPortal>
      <Menu.Target>
        <Tooltip label={label}>
          <ActionIcon
            variant="subtle"
            color="gray"
            size="lg"
            aria-label={label}
            data-testid="language"
          >
            <IconLanguage size={18} stroke={1.6} />
          </ActionIcon>
        </Tooltip>
      </Menu.Target>
      <Menu.Dropdown>
        {(Object.keys(LANGUAGES) as Language[]).map((one) => (
          <Menu.Item
            key={one}
            lang={one}
            rightSection={one === language && <IconCheck size={14} aria-hidden />}
            aria-current={one === language}
            disabled={one === language}
            onClick={() => changeLanguage(one)}
            data-testid={`language-${one}`}
          >
            {LANGUAGES[one]}
          </Menu.Item>
        ))}
      </Menu.Dropdown>
    </Menu>
  );
}
