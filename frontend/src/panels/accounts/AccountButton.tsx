/** Button and section that show the account of the person who uses the page. */

import { Indicator, Paper, Text, Tooltip } from "@mantine/core";
import { IconShieldLock } from "@tabler/icons-react";
import { lazy, Suspense, useEffect, useRef, useState } from "react";
import { translate } from "../../language/translate";
import { useMe } from "../../state/accounts/accounts";
import { type AccountTab, showSettings } from "../../state/routes";
import { Dialog } from "../shared/Dialog";

// Few people open it, so the start page does without it.
const Account = lazy(() => import("./Account").then((module) => ({ default: module.Account })));

/** Opens the dialog; a mark shows that there is no administrator. */
export function AccountButton({ className }: { readonly className: string | undefined }) {
  const me = useMe();
  const [opened, setOpened] = useState(false);
  const [tab, setTab] = useState<AccountTab>("own");
  if (me === undefined) return null;
  const label =
    me.kind === "local"
      ? translate("accountDialog.accountSignInIsNot")
      : translate("accountDialog.account", { name: me.name });
  return (
    <>
      <Tooltip label={label}>
        <button
          type="button"
          className={className}
          aria-label={label}
          onClick={() => setOpened(true)}
          data-testid="account"
        >
          <Indicator lh={0} disabled={me.has_admin} color="orange" size={9} offset={2} withBorder>
            <IconShieldLock />
          </Indicator>
          <span>{translate("accountDialog.account2")}</span>
        </button>
      </Tooltip>
      <Dialog
        opened={opened}
        onClose={() => setOpened(false)}
        title={translate("accountDialog.account2")}
        size="xl"
        centered
      >
        <Suspense fallback={null}>
          <Account me={me} tab={tab} onTab={setTab} />
        </Suspense>
      </Dialog>
    </>
  );
}

/** The same as a section of a page, with the tab in the address. */
export function AccountSection({ tab }: { readonly tab: AccountTab }) {
  const me = useMe();
  const section = useRef<HTMLElement>(null);
  // A link to a tab shows it, below the other settings.
  useEffect(() => {
    if (tab !== "own" && me !== undefined) section.current?.scrollIntoView();
  }, [tab, me]);
  if (me === undefined || (me.kind === "local" && me.has_admin)) return null;
  return (
    <Paper component="section" ref={section} radius={12} px={18} py={14} bg="var(--panel)">
      <Text fw={600} mb={6}>
        {translate("accountDialog.account2")}
      </Text>
      <Suspense fallback={null}>
        <Account me={me} tab={tab} onTab={showSettings} />
      </Suspense>
    </Paper>
  );
}
