/** Shown at an address that names nothing: what is not there, and the way back. */

import { Button, Center, Stack, Title } from "@mantine/core";
import { TO_ALL_DRAWINGS } from "../panels/shared/labels";

interface Props {
  readonly text: string;
  /** Where the button leads, and its text. */
  readonly href?: string;
  readonly label?: string;
}

export function NotFound({ text, href = "#/", label = TO_ALL_DRAWINGS }: Props) {
  return (
    <Center h="100%" p={24} role="alert" data-testid="not-found">
      <Stack align="center" gap={16}>
        <Title order={1} fz={20} ta="center" style={{ overflowWrap: "anywhere" }}>
          {text}
        </Title>
        <Button component="a" href={href} variant="default">
          {label}
        </Button>
      </Stack>
    </Center>
  );
}
