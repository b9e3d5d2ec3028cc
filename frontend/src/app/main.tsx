/** Entry point of the page. */

import "@fontsource-variable/inter";
import "@mantine/core/styles.css";
import "./app.css";
import { MantineProvider } from "@mantine/core";
import { QueryClientProvider } from "@tanstack/react-query";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Router } from "wouter";
import { useHashLocation } from "wouter/use-hash-location";
import { language } from "../language/language";
import { queryClient } from "../state/queries";
import { openAddress } from "../state/routes";
import { App } from "./App";
import { theme } from "./theme";

const root = document.getElementById("root");
if (root === null) throw new Error("#root");

document.documentElement.lang = language;
// Before the first rendering, so that no other view is seen or fetched.
openAddress();
createRoot(root).render(
  <StrictMode>
    <MantineProvider theme={theme} defaultColorScheme="auto">
      <QueryClientProvider client={queryClient}>
        <Router hook={useHashLocation}>
          <App />
        </Router>
      </QueryClientProvider>
    </MantineProvider>
  </StrictMode>,
);
