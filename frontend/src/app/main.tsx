/** Entry point of the page. */

import "@fontsource-variable/inter";
import "@mantine/core/styles.css";
import "./app.css";
import { MantineProvider } from "@mantine/core";
import { QueryClientProvider } from "@tanstack/react-query";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { queryClient } from "../state/queries";
import { App } from "./App";
import { openAddress } from "./routes";
import { theme } from "./theme";

const root = document.getElementById("root");
if (root === null) throw new Error("The page has no element #root.");

// Before the first rendering, so that no other view is seen or fetched.
openAddress();
createRoot(root).render(
  <StrictMode>
    <MantineProvider theme={theme} defaultColorScheme="auto">
      <QueryClientProvider client={queryClient}>
        <App />
      </QueryClientProvider>
    </MantineProvider>
  </StrictMode>,
);
