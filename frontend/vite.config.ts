import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

const backend = process.env.PNEUSTUDIO_BACKEND ?? "http://127.0.0.1:8000";

export default defineConfig({
  plugins: [react()],
  build: { outDir: "dist", target: "es2022", sourcemap: false },
  server: {
    proxy: { "/api": { target: backend, ws: true } },
  },
  test: { environment: "node", include: ["src/**/*.test.{ts,tsx}"] },
});
