import assert from "node:assert/strict";
import { test } from "node:test";

import { isDialect, mayBeOfAProgram } from "../../src/languages";
import { argumentsOf, folderOf } from "../../src/program";
import { Cancelled, firstError, NotFound, runPlcxx } from "../../src/tool";

test("a program that is not there is named, with the remedy", async () => {
  await assert.rejects(runPlcxx("/no/such/plcxx", ["lsp"], "/"), (error: Error) => {
    assert.ok(error instanceof NotFound);
    assert.match(error.message, /'\/no\/such\/plcxx' cannot be started \(there is no such program\)/);
    assert.match(error.message, /setting 'plcxx\.path'/);
    return true;
  });
});

test("what a command says and how it ends", async () => {
  const ran = await runPlcxx(process.execPath, ["-e", "console.log('out'); console.error('err'); process.exit(2)"], "/");
  assert.deepEqual(ran, { exitCode: 2, stdout: "out\n", stderr: "err\n" });
});

test("a command is ended when it is cancelled", async () => {
  const cancel = new AbortController();
  const run = runPlcxx(process.execPath, ["-e", "setTimeout(() => {}, 60000)"], "/", cancel.signal);
  setTimeout(() => cancel.abort(), 50);
  await assert.rejects(run, Cancelled);
  await assert.rejects(runPlcxx(process.execPath, [], "/", cancel.signal), Cancelled);
});

test("the error comes before the notes", () => {
  assert.equal(firstError("a.plc:1:1: note: x\na.plc:2:1: error: y\n"), "a.plc:2:1: error: y");
  assert.equal(firstError(""), "plcxx said nothing");
});

test("a program of a project is called by its name, another one by its files", () => {
  const project = { dialect: "nc110", project: "/m/plcxx.yaml", program: "lathe", sources: ["/m/a.plc"] };
  assert.deepEqual(argumentsOf(project), { options: ["--project", "/m/plcxx.yaml", "--program", "lathe"], sources: [] });
  assert.equal(folderOf(project), "/m");
  const alone = { dialect: "nc110", project: null, program: "", sources: ["/m/b/a.plc"] };
  assert.deepEqual(argumentsOf(alone), { options: ["--dialect", "nc110"], sources: ["/m/b/a.plc"] });
  assert.equal(folderOf(alone), "/m/b");
});

test("which files are worth a question", () => {
  assert.ok(isDialect("hnc") && !isDialect("plc"));
  assert.ok(mayBeOfAProgram("/m/a.plc", "plc"));
  assert.ok(mayBeOfAProgram("/m/axes.h", "c"));
  assert.ok(mayBeOfAProgram("/m/KONST.INC", "plaintext"));
  assert.ok(!mayBeOfAProgram("/m/a.sym", "nc110"));
  assert.ok(!mayBeOfAProgram("/m/a.txt", "plaintext"));
});
