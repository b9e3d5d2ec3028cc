/** Account of the person who uses the page; for administrators also users, keys and audit log. */

import {
  Box,
  Button,
  Code,
  Flex,
  MultiSelect,
  PasswordInput,
  Select,
  Tabs,
  Text,
  TextInput,
} from "@mantine/core";
import { type ReactNode, useState } from "react";
import { type AccessScope, accounts, type Me, type User, type UserRole } from "../../api/accounts";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { errorText } from "../../messages/translateMessage";
import {
  createFirstAdmin,
  ROLE_TITLES,
  ROLES,
  refreshKeys,
  refreshUsers,
  roleOf,
  roleTitle,
  signOut,
  useAudit,
  useKeys,
  useUsers,
} from "../../state/accounts/accounts";
import { useMachines } from "../../state/queries";
import type { AccountTab } from "../../state/routes";
import { dateTimeText } from "../../state/times";
import css from "./account.module.css";

const ROLE_OPTIONS = ROLES.map((role) => ({ value: role, label: ROLE_TITLES[role] }));
const SCOPES: readonly AccessScope[] = [
  ...(["read", "order", "webhooks", "station", "gateway"] as const),
  ...ROLES,
];
const PERMITS: Readonly<Record<UserRole, string>> = {
  viewer: translate("accountDialog.youCanViewDrawingsJobs"),
  designer: translate("accountDialog.youCanUploadAndChange"),
  operator: translate("accountDialog.youCanOrderReleaseAnd"),
  admin: translate("accountDialog.youCanDoEverythingAnd"),
};

interface Props {
  readonly me: Me;
  readonly tab: AccountTab;
  onTab(tab: AccountTab): void;
}

export function Account({ me, tab, onTab }: Props) {
  if (!me.scopes.includes("admin")) return <Own me={me} />;
  return (
    <Tabs value={tab} onChange={(value) => onTab(value as AccountTab)} keepMounted={false}>
      <Tabs.List>
        <Tabs.Tab value="own">{translate("accountDialog.myAccount")}</Tabs.Tab>
        <Tabs.Tab value="users">{translate("accountDialog.users")}</Tabs.Tab>
        <Tabs.Tab value="keys">{translate("accountDialog.apiKeys")}</Tabs.Tab>
        <Tabs.Tab value="audit">{translate("accountDialog.auditLog")}</Tabs.Tab>
      </Tabs.List>
      <Tabs.Panel value="own">
        <Own me={me} />
      </Tabs.Panel>
      <Tabs.Panel value="users">
        <Users />
      </Tabs.Panel>
      <Tabs.Panel value="keys">
        <Keys />
      </Tabs.Panel>
      <Tabs.Panel value="audit">
        <Audit />
      </Tabs.Panel>
    </Tabs>
  );
}

function Own({ me }: { me: Me }) {
  const role = roleOf(me.scopes);
  if (me.kind === "local") return me.has_admin ? null : <FirstAdmin />;
  if (me.kind === "device") return <PairedDevice me={me} />;
  return (
    <Flex component="section" direction="column" gap={16} pt={16} align="flex-start">
      <p data-testid="account-name">
        {translateRich("accountDialog.signedInAs", {
          name: me.name,
          role: roleTitle(me.scopes),
          strong: (children) => <strong>{children}</strong>,
        })}
        {role !== null && ` ${PERMITS[role]}`}
      </p>
      <Button variant="default" onClick={() => void signOut()} data-testid="sign-out">
        {translate("accountDialog.signOut")}
      </Button>
      {me.sign_in === "password" && <OwnPassword />}
      {me.sign_in === "oidc" && <p>{translate("accountDialog.yourPasswordAndYourRole")}</p>}
    </Flex>
  );
}

function PairedDevice({ me }: { me: Me }) {
  return (
    <Flex component="section" direction="column" gap={16} pt={16} align="flex-start">
      <p data-testid="account-name">
        {translateRich("accountDialog.thisDeviceIsPairedWith", {
          name: me.name,
          machines: me.machines.join(", "),
          strong: (children) => <strong>{children}</strong>,
        })}
      </p>
      <Button variant="default" onClick={() => void signOut()} data-testid="unpair">
        {translate("accountDialog.unpairThisDevice")}
      </Button>
    </Flex>
  );
}

/** A form that shows the result of its request: a confirmation or the error. */
function RequestForm({
  send,
  label,
  children,
}: {
  readonly send: (form: FormData) => Promise<string>;
  readonly label: string;
  readonly children: ReactNode;
}) {
  const [note, setNote] = useState({ text: "", failed: false });
  const action = async (form: FormData) => {
    try {
      setNote({ text: await send(form), failed: false });
    } catch (error) {
      setNote({ text: errorText(error as Error), failed: true });
    }
  };
  return (
    <form className={css.form} action={action} aria-label={label}>
      {children}
      <Button type="submit">{label}</Button>
      {note.text !== "" && (
        <Text
          flex="1 0 100%"
          c={note.failed ? "var(--bad-ink)" : "ink.2"}
          role={note.failed ? "alert" : "status"}
        >
          {note.text}
        </Text>
      )}
    </form>
  );
}

const textOf = (form: FormData, name: string): string => String(form.get(name) ?? "");

function FirstAdmin() {
  const send = async (form: FormData) => {
    await createFirstAdmin(textOf(form, "name"), textOf(form, "password"));
    return "";
  };
  return (
    <Flex
      component="section"
      direction="column"
      gap={16}
      pt={16}
      align="flex-start"
      data-testid="first-admin"
    >
      <p>{translate("accountDialog.noAdministratorExistsYetEvery")}</p>
      <Code block>knifetip user add NAME --role admin</Code>
      <RequestForm send={send} label={translate("accountDialog.createTheAdministrator")}>
        <TextInput
          label={translate("accountDialog.name")}
          name="name"
          required
          maxLength={64}
          autoComplete="username"
        />
        <NewPassword />
      </RequestForm>
    </Flex>
  );
}

function NewPassword({ name = "password", label = translate("accountDialog.password") }) {
  return (
    <PasswordInput
      label={label}
      description={translate("accountDialog.atLeastTenCharacters")}
      name={name}
      required
      minLength={10}
      autoComplete="new-password"
    />
  );
}

function OwnPassword() {
  const send = async (form: FormData) => {
    await accounts.changePassword(textOf(form, "current"), textOf(form, "new"));
    return translate("accountDialog.passwordChangedYourOtherSessions");
  };
  return (
    <RequestForm send={send} label={translate("accountDialog.changeThePassword")}>
      <PasswordInput
        label={translate("accountDialog.currentPassword")}
        name="current"
        required
        autoComplete="current-password"
      />
      <NewPassword name="new" label={translate("accountDialog.newPassword")} />
    </RequestForm>
  );
}

function Users() {
  const { data: users = [] } = useUsers();
  const send = async (form: FormData) => {
    const name = textOf(form, "name");
    await accounts.createUser(name, textOf(form, "password"), textOf(form, "role") as UserRole);
    await refreshUsers();
    return translate("accountDialog.userCreated", { name });
  };
  return (
    <Flex
      component="section"
      direction="column"
      gap={16}
      pt={16}
      align="flex-start"
      data-testid="users"
    >
      <Box component="ul" w="100%" mah="44vh" style={{ overflow: "auto" }}>
        {users.map((user) => (
          <UserRow key={user.name} user={user} />
        ))}
      </Box>
      <RequestForm send={send} label={translate("accountDialog.createAUser")}>
        <TextInput
          label={translate("accountDialog.name")}
          name="name"
          required
          maxLength={64}
          autoComplete="off"
        />
        <Select
          label={translate("accountDialog.role")}
          name="role"
          data={ROLE_OPTIONS}
          defaultValue="designer"
        />
        <NewPassword />
      </RequestForm>
    </Flex>
  );
}

function UserRow({ user }: { user: User }) {
  const [fault, setFault] = useState("");
  const change = async (body: { role?: UserRole; active?: boolean }) => {
    try {
      await accounts.changeUser(user.name, body);
      setFault("");
    } catch (error) {
      setFault(errorText(error as Error));
    }
    await refreshUsers();
  };
  const last =
    user.signed_in === null
      ? translate("accountDialog.neverSignedIn")
      : dateTimeText(user.signed_in);
  return (
    <li className={css.item}>
      <Box
        component="span"
        display="grid"
        flex="1 1 180px"
        miw={0}
        style={{ overflowWrap: "anywhere" }}
      >
        <strong>{user.name}</strong>
        <small>{user.active ? last : translate("accountDialog.disabled")}</small>
      </Box>
      <Select
        aria-label={translate("accountDialog.roleOf", { name: user.name })}
        data={ROLE_OPTIONS}
        value={user.role}
        allowDeselect={false}
        onChange={(role) => void change({ role: role as UserRole })}
      />
      <Button variant="default" onClick={() => void change({ active: !user.active })}>
        {user.active ? translate("accountDialog.disable") : translate("accountDialog.enable")}
      </Button>
      {fault !== "" && (
        <Text flex="1 0 100%" c="var(--bad-ink)" role="alert">
          {fault}
        </Text>
      )}
    </li>
  );
}

function Keys() {
  const { data: keys = [] } = useKeys();
  const [scopes, setScopes] = useState<AccessScope[]>(["order"]);
  const [machines, setMachines] = useState<string[]>([]);
  const { data: known = [] } = useMachines();
  const [secret, setSecret] = useState("");
  const send = async (form: FormData) => {
    const day = textOf(form, "expires");
    const expires = day === "" ? null : new Date(day).toISOString();
    const title = textOf(form, "title");
    const customer = textOf(form, "customer");
    setSecret(await accounts.createKey({ title, scopes, expires, customer, machines }));
    await refreshKeys();
    return translate("accountDialog.copyTheKeyNowIt");
  };
  const revoke = async (id: string) => {
    await accounts.revokeKey(id);
    await refreshKeys();
  };
  return (
    <Flex
      component="section"
      direction="column"
      gap={16}
      pt={16}
      align="flex-start"
      data-testid="keys"
    >
      <Box component="ul" w="100%" mah="44vh" style={{ overflow: "auto" }}>
        {keys.map((key) => (
          <li key={key.id} className={css.item}>
            <Box
              component="span"
              display="grid"
              flex="1 1 180px"
              miw={0}
              style={{ overflowWrap: "anywhere" }}
            >
              <strong>{key.title}</strong>
              <small>{`${key.scopes.join(", ")} · ${key.used === null ? translate("accountDialog.neverUsed") : translate("accountDialog.used", { used: dateTimeText(key.used) })}${key.customer !== "" ? ` · ${translate("accountDialog.customer", { customer: key.customer })}` : ""}${key.machines.length > 0 ? ` · ${key.machines.join(", ")}` : ""}${key.scopes.includes("gateway") && key.any_machine ? ` · ${translate("accountDialog.anyMachine")}` : ""}${key.expires !== null ? ` · ${translate("accountDialog.expires", { expires: dateTimeText(key.expires) })}` : ""}`}</small>
            </Box>
            {key.revoked === null ? (
              <Button variant="default" onClick={() => void revoke(key.id)}>
                {translate("accountDialog.revoke")}
              </Button>
            ) : (
              <small>{translate("accountDialog.revoked")}</small>
            )}
          </li>
        ))}
      </Box>
      <RequestForm send={send} label={translate("accountDialog.createAKey")}>
        <TextInput
          label={translate("accountDialog.usedBy")}
          description={translate("accountDialog.programThatUsesTheKey")}
          name="title"
          required
          maxLength={100}
        />
        <MultiSelect
          label={translate("accountDialog.scopes")}
          description={translate("accountDialog.noRoleLetsAKey")}
          data={[...SCOPES]}
          value={scopes}
          onChange={(chosen) => setScopes(chosen as AccessScope[])}
        />
        <TextInput
          label={translate("accountDialog.customerOptional")}
          description={translate("accountDialog.theKeySeesAndOrders")}
          name="customer"
          maxLength={200}
        />
        <MultiSelect
          label={translate("accountDialog.machinesOptional")}
          description={translate("accountDialog.theKeyIsForThese")}
          data={known.map((machine) => machine.name)}
          value={machines}
          onChange={setMachines}
        />
        <TextInput label={translate("accountDialog.expiresOptional")} name="expires" type="date" />
      </RequestForm>
      {secret !== "" && (
        <Code block data-testid="key-secret">
          {secret}
        </Code>
      )}
    </Flex>
  );
}

function Audit() {
  const { data: entries = [] } = useAudit();
  return (
    <Flex
      component="section"
      direction="column"
      gap={16}
      pt={16}
      align="flex-start"
      data-testid="audit"
    >
      <Box component="ul" w="100%" mah="44vh" style={{ overflow: "auto" }}>
        {entries.map((entry) => (
          <li key={entry.id} className={css.item} data-failed={entry.outcome !== "done"}>
            <small>{dateTimeText(entry.at)}</small>
            <Box
              component="span"
              display="grid"
              flex="1 1 180px"
              miw={0}
              style={{ overflowWrap: "anywhere" }}
            >
              {`${entry.principal || translate("accountDialog.unknown")}: ${entry.action.replaceAll("_", " ")} ${entry.subject}`}
            </Box>
            <small>{`${entry.outcome} · ${entry.peer}`}</small>
          </li>
        ))}
      </Box>
    </Flex>
  );
}
