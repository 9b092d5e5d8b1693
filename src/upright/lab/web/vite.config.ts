import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { defineConfig } from "vite";

// What the page was built from: a test compares it with the source, and needs no build.
function sourceHash(): string {
  const hash = createHash("sha256");
  const inside = readdirSync("src", { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const files = inside.map((entry) => `${entry.parentPath}/${entry.name}`);
  const around = ["index.html", "package.json", "package-lock.json", "tsconfig.json", "vite.config.ts"];
  for (const file of [...files, ...around].sort()) {
    hash.update(`${file}\n`).update(readFileSync(file));
  }
  return hash.digest("hex");
}

// Names without hashes, so that a new build changes contents and not the list of files; relative addresses, so that
// the page works under any path. The server forbids stale caching.
export default defineConfig({
  base: "./",
  plugins: [
    {
      name: "source-hash",
      generateBundle() {
        this.emitFile({ type: "asset", fileName: "source.sha256", source: sourceHash() });
      },
    },
  ],
  build: {
    outDir: "../static",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: false,
    chunkSizeWarningLimit: 1000,
    rollupOptions: {
      output: {
        entryFileNames: "assets/lab.js",
        chunkFileNames: "assets/[name].js",
        assetFileNames: "assets/lab[extname]",
        inlineDynamicImports: true,
      },
    },
  },
});
