// Bundles the extension and its tests; copies what belongs to the whole project into the extension.
// usage: node build.mjs [--production]
import { build } from "esbuild";
import { copyFileSync, mkdirSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const production = process.argv.includes("--production");
// Where the project is when a test builds a copy of this folder.
const project = process.env.PLCXX_PROJECT ?? join(here, "..", "..");

mkdirSync(join(here, "schemas"), { recursive: true });
copyFileSync(join(project, "docs", "plcxx.schema.json"), join(here, "schemas", "plcxx.schema.json"));
copyFileSync(join(project, "LICENSE"), join(here, "LICENSE"));

const common = { bundle: true, platform: "node", target: "node18", format: "cjs", external: ["vscode"], logLevel: "warning" };
await build({
  ...common,
  entryPoints: [join(here, "src", "extension.ts")],
  outfile: join(here, "dist", "extension.js"),
  minify: production,
  sourcemap: !production,
});
if (!production) {
  const unit = join(here, "test", "unit");
  await build({
    ...common,
    entryPoints: readdirSync(unit).filter((name) => name.endsWith(".test.ts")).map((name) => join(unit, name)),
    outdir: join(here, "dist", "test"),
  });
}
