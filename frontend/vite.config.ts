import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

const API = process.env.KNIFETIP_API ?? "http://127.0.0.1:8080";

export default defineConfig({
  plugins: [react()],
  build: {
    outDir: "../backend/knifetip/service/page",
    emptyOutDir: true,
    chunkSizeWarningLimit: 1600,
    rolldownOptions: {
      // The page, and the description of the REST API.
      input: ["index.html", "docs.html"],
      output: {
        // Large libraries that few views need, and those that every view needs, which would be
        // many small files; others are divided by what imports them.
        codeSplitting: {
          groups: [
            { name: "swagger", test: /node_modules[\\/]swagger-ui-dist/, priority: 1 },
            { name: "three", test: /node_modules[\\/]three/, priority: 1 },
            { name: "libraries", test: /node_modules[\\/]/, tags: ["$initial"] },
          ],
        },
      },
    },
  },
  server: {
    // The service answers only to pages of its own origin.
    proxy: { "/api": { target: API, changeOrigin: true, headers: { Origin: API } } },
  },
  test: {
    environment: "node",
    include: ["src/**/*.test.ts"],
    setupFiles: ["src/messages/load.ts"],
    // A test fails if it hangs, not because the computer is busy.
    testTimeout: 120_000,
    hookTimeout: 120_000,
  },
});
