/** Settings: language, colour scheme, name of the operator, accounts, webhooks, shortcuts. */

import {
  Button,
  Paper,
  SegmentedControl,
  Stack,
  Text,
  Title,
  useMantineColorScheme,
} from "@mantine/core";
import type { ReactNode } from "react";
import { changeLanguage, LANGUAGES, type Language, language } from "../language/language";
import { translate } from "../language/translate";
import { AccountSection } from "../panels/accounts/AccountButton";
import { OperatorButton } from "../panels/accounts/OperatorForm";
import panels from "../panels/shared/panels.module.css";
import type { AccountTab } from "../state/routes";
import { useUiStore } from "../state/store";

const SCHEMES = [
  { value: "auto", label: translate("settingsPage.asTheSystem") },
  { value: "light", label: translate("settingsPage.light") },
  { value: "dark", label: translate("settingsPage.dark") },
];

interface Props {
  /** Tab of the account of an administrator. */
  readonly tab: AccountTab;
}

export function SettingsPage({ tab }: Props) {
  const { colorScheme, setColorScheme } = useMantineColorScheme();
  const set = useUiStore((ui) => ui.set);
  return (
    <main className={panels.page} data-testid="settings">
      <header className={panels.head} style={{ maxWidth: 760 }}>
        <Title order={1} fz={22}>
          {translate("settingsPage.settings")}
        </Title>
      </header>
      <Stack gap={14} maw={760}>
        <Group title={translate("languageMenu.language")}>
          <SegmentedControl
            aria-label={translate("languageMenu.language")}
            value={language}
            onChange={(value) => changeLanguage(value as Language)}
            data={(Object.keys(LANGUAGES) as Language[]).map((one) => ({
              value: one,
              label: (
                <span lang={one} data-testid={`language-${one}`}>
                  {LANGUAGES[one]}
                </span>
              ),
            }))}
          />
        </Group>
        <Group title={translate("settingsPage.colourScheme")}>
          <SegmentedControl
            aria-label={translate("settingsPage.colourScheme")}
            value={colorScheme}
            onChange={(value) => setColorScheme(value as typeof colorScheme)}
            data={SCHEMES}
            data-testid="scheme"
          />
        </Group>
        <Group title={translate("settingsPage.nameOfTheOperator")}>
          <OperatorButton />
        </Group>
        <Group title={translate("settingsPage.otherSystems")}>
          <Button component="a" href="#/webhooks" variant="default" data-testid="open-webhooks">
            {translate("machinePanel.webhooks")}
          </Button>
          <Button component="a" href="/docs" variant="default">
            {translate("settingsPage.descriptionOfTheApi")}
          </Button>
        </Group>
        <Group title={translate("settingsPage.help")}>
          <Button variant="default" onClick={() => set({ helpOpen: true })}>
            {translate("topBar.keyboardAndMouseShortcuts")}
          </Button>
        </Group>
        <AccountSection tab={tab} />
      </Stack>
    </main>
  );
}

function Group({ title, children }: { title: string; children: ReactNode }) {
  return (
    <Paper component="section" radius={12} px={18} py={14} bg="var(--panel)" aria-label={title}>
      <Text fw={600} mb={10}>
        {title}
      </Text>
      <div style={{ display: "flex", flexWrap: "wrap", gap: 10 }}>{children}</div>
    </Paper>
  );
}
