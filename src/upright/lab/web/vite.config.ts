import { defineConfig } from "vite";

// Names without hashes, so that a new build changes contents and not the list of files; relative addresses, so that
// the page works under any path. The server forbids stale caching.
export default defineConfig({
  base: "./",
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
