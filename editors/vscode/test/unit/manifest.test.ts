// package.json against what the code and the tool know.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { DIALECTS, LANGUAGES } from "../../src/languages";

const FOLDER = join(__dirname, "..", "..");
const read = (name: string) => JSON.parse(readFileSync(join(FOLDER, name), "utf8"));
const { contributes } = read("package.json");

test("each language has its configuration, each dialect its grammar", () => {
  assert.deepEqual(contributes.languages.map((one: { id: string }) => one.id).sort(), [...LANGUAGES].sort());
  for (const language of contributes.languages) {
    const configuration = read(language.configuration);
    assert.ok(configuration.comments.lineComment, language.id);
    assert.ok(configuration.brackets.length > 0, language.id);
    for (const marker of Object.values(configuration.folding?.markers ?? {})) new RegExp(marker as string);
    if (configuration.wordPattern) new RegExp(configuration.wordPattern);
  }
  for (const dialect of DIALECTS) {
    const grammar = contributes.grammars.find((one: { language: string }) => one.language === dialect);
    assert.equal(read(grammar.path).scopeName, `source.${dialect}`);
  }
  assert.deepEqual(contributes.configuration.properties["plcxx.dialect"].enum, ["auto", ...DIALECTS]);
});

test("each command is registered, each setting read", () => {
  const sources = ["client", "commands", "cpp_beside", "extension", "machine_live", "pages", "tasks", "test_explorer"]
    .map((name) => readFileSync(join(FOLDER, "src", `${name}.ts`), "utf8")).join("\n");
  for (const { command } of contributes.commands) assert.ok(sources.includes(`registerCommand("${command}"`), command);
  for (const setting of Object.keys(contributes.configuration.properties)) {
    if (setting === "plcxx.trace.server") continue;  // the client's own
    assert.ok(sources.includes(`"${setting.split(".")[1]}"`), setting);
  }
});

test("the problem matchers take plcxx's messages", () => {
  const matcherOf = (name: string) => {
    const { pattern } = contributes.problemMatchers.find((one: { name: string }) => one.name === name);
    return (line: string) => {
      const found = new RegExp(pattern.regexp).exec(line);
      const at = (key: string) => found?.[pattern[key]];
      return found === null ? null : [at("file"), at("line"), at("column"), at("severity"), at("message"), at("code")];
    };
  };
  const messages = matcherOf("plcxx");
  assert.deepEqual(messages("fast.plc:50:2: warning: backward jump to 'NAST' [prostep-W15]"),
    ["fast.plc", "50", "2", "warning", "backward jump to 'NAST'", "prostep-W15"]);
  assert.deepEqual(messages("C:\\m\\a.plc:1:3: error: [ is open [nc110-41]"),
    ["C:\\m\\a.plc", "1", "3", "error", "[ is open", "nc110-41"]);
  assert.equal(messages("   50 | :JC NAST"), null);
  const scenarios = matcherOf("plcxx-scenario");
  assert.deepEqual(scenarios("spindle.yaml:8:12: step 5 (expect), at 1510 ms: expected !MACON = 0, found 1")?.slice(0, 3),
    ["spindle.yaml", "8", "12"]);
  assert.equal(scenarios("    value 1 at 1500 ms: fast.plc:69:1: !MACON = T0U"), null);
});
