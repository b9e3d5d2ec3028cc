/** The window of a dialog, in a file of its own so that it is fetched when a dialog is opened. */

export { Modal as DialogWindow } from "@mantine/core";
