// The packed extension with a stub of the editor and the real plcxx: what a user does in one sitting.
// usage: session.cjs EXTENSION.js PLCXX PROJECT
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const Module = require("node:module");
const os = require("node:os");
const path = require("node:path");

const [extensionFile, plcxx, project] = process.argv.slice(2).map((one) => path.resolve(one));
const stubFile = path.join(__dirname, "vscode_stub.cjs");
const resolve = Module._resolveFilename;
Module._resolveFilename = (request, ...rest) => (request === "vscode" ? stubFile : resolve(request, ...rest));
const vscode = require(stubFile);
const { recorded, event } = vscode.stub;

const folder = fs.realpathSync(fs.mkdtempSync(path.join(os.tmpdir(), "plcxx-test-")));
const extension = require(extensionFile);
const context = { subscriptions: [] };

async function until(what, condition) {
  for (const end = Date.now() + 60000; Date.now() < end;) {
    const found = await condition();
    if (found) return found;
    await new Promise((wake) => setTimeout(wake, 20));
  }
  throw new Error(`waited in vain for ${what}: ${JSON.stringify([recorded.errors, recorded.output.slice(-10)])}`);
}

const fileUri = (name) => vscode.Uri.file(path.join(folder, name));

async function open(name) {
  const document = await vscode.workspace.openTextDocument(fileUri(name));
  const editor = await vscode.window.showTextDocument(document);
  vscode.window.activeTextEditor = editor;
  return { document, editor };
}

/** The first `from` becomes `to`, as if it were typed. */
async function type(document, from, to) {
  const at = document.text.indexOf(from);
  assert.ok(at >= 0, `'${from}' is in the text`);
  const before = document.text.slice(0, at).split("\n");
  const start = new vscode.Position(before.length - 1, before.at(-1).length);
  document.text = document.text.replace(from, to);
  document.version += 1;
  document.isDirty = true;
  const range = new vscode.Range(start, new vscode.Position(start.line, start.character + from.length));
  await event("onDidChangeTextDocument").fire({ document, contentChanges: [{ range, rangeLength: from.length, text: to }] });
}

async function save(document) {
  fs.writeFileSync(document.uri.fsPath, document.text);
  document.isDirty = false;
  await event("onDidSaveTextDocument").fire(document);
}

const diagnosticsOf = (document) => recorded.diagnostics.get(document.uri.toString());
const token = new vscode.CancellationTokenSource().token;
const lineOf = (text, start) => text.split("\n").findIndex((line) => line.startsWith(start));

function checkPolicy(html) {
  assert.match(html, /Content-Security-Policy" content="default-src 'none'/);
  assert.ok(!html.includes("unsafe-inline") && !html.includes("unsafe-eval"));
  assert.ok(!/<script(?![^>]* nonce=)/.test(html) && !/<style(?![^>]* nonce=)/.test(html), "everything has its nonce");
  assert.ok(!/<\w[^<>]* (style|on[a-z]+)="/.test(html.replace(/<script[\s\S]*?<\/script>/g, "")), "no inline styles or handlers");
}

async function languageServer() {
  const { document } = await open("fast.plc");
  assert.equal(document.languageId, "nc110", "the program's language, not only '.plc'");
  await until("diagnostics", () => diagnosticsOf(document));
  assert.ok(diagnosticsOf(document).every((one) => one.severity !== 0));
  const position = new vscode.Position(lineOf(document.text, "!KDRV ="), 2);
  const hover = await recorded.providers.get("registerHoverProvider").provideHover(document, position, token);
  assert.match(JSON.stringify(hover), /contactor of the drives/i);
  const definition = await recorded.providers.get("registerDefinitionProvider").provideDefinition(document, position, token);
  assert.match(JSON.stringify(definition), /lathe\.sym/);
  await type(document, "!KDRV =", "!KDRV = = ");
  await until("the error", () => diagnosticsOf(document)?.some((one) => one.severity === 0 && one.range.start.line === position.line));
  await type(document, "!KDRV = = ", "!KDRV =");
  await until("no error", () => diagnosticsOf(document)?.every((one) => one.severity !== 0));
  const header = await open("lathe.sym");
  assert.equal(header.document.languageId, "nc110");
}

async function scenarios() {
  const [controller] = recorded.controllers;
  const file = path.join(folder, "spindle.yaml");
  const text = fs.readFileSync(file, "utf8");
  fs.writeFileSync(file, text.replace('"!MACON": 1', '"!MACON": 0'));
  fs.writeFileSync(path.join(folder, "broken.yaml"), "steps:\n- foo: 1\n");
  await controller.resolveHandler(undefined);
  const names = [];
  controller.items.forEach((item) => item.children.forEach((child) => names.push(child.label)));
  assert.ok(names.includes("spindle.yaml") && names.includes("power_on.yaml") && !names.includes("plcxx.yaml"), names.join());
  const chosen = [];
  controller.items.forEach((item) => item.children.forEach((child) => {
    if (["spindle.yaml", "power_on.yaml", "broken.yaml"].includes(child.label)) chosen.push(child);
  }));
  recorded.settings.set("plcxx.testEngine", "sim");
  await controller.profiles[0].run({ include: chosen }, token);
  const run = controller.runs.at(-1);
  assert.ok(run.ended);
  assert.deepEqual(run.passedItems.map((item) => item.label), ["power_on.yaml"]);
  const [failure] = run.failedItems;
  assert.equal(failure.item.label, "spindle.yaml");
  const at = text.split("\n").findIndex((line) => line.includes('"!MACON": 1'));
  assert.equal(failure.message.location.range.start.line, at, "at its line");
  assert.equal(failure.message.location.uri.fsPath, file);
  assert.deepEqual([failure.message.expectedOutput, failure.message.actualOutput], ["0", "1"]);
  assert.match(run.erroredItems[0].message.message, /broken\.yaml:2:3: 'foo' is no step/);
  assert.match(run.output, /FAILED/);
  fs.writeFileSync(file, text);
  fs.rmSync(path.join(folder, "broken.yaml"));
  await controller.refreshHandler();
  const left = [];
  controller.items.forEach((item) => item.children.forEach((child) => left.push(child.label)));
  assert.ok(!left.includes("broken.yaml"), "what is gone is gone from the list");
}

async function cppBeside() {
  const { document, editor } = await open("fast.plc");
  await vscode.commands.executeCommand("plcxx.cppBeside");
  const shown = vscode.window.visibleTextEditors.at(-1);
  assert.equal(shown.document.uri.scheme, "plcxx-cpp");
  assert.equal(shown.document.languageId, "cpp");
  assert.match(shown.document.text, /m\[KDRV\] = /);
  assert.ok(!shown.document.text.includes("#line"));
  const line = lineOf(document.text, "!KDRV =");
  editor.selection = new vscode.Selection(new vscode.Position(line, 0), new vscode.Position(line, 0));
  await event("onDidChangeTextEditorSelection").fire({ textEditor: editor });
  const [marked] = recorded.decorations.get(shown.document.uri.toString());
  assert.match(shown.document.text.split("\n")[marked.start.line], /m\[KDRV\] = /);
  shown.selection = new vscode.Selection(marked.start, marked.start);
  recorded.decorations.clear();
  await event("onDidChangeTextEditorSelection").fire({ textEditor: shown });
  assert.equal(recorded.decorations.get(document.uri.toString())[0].start.line, line, "and back");
  await type(document, "!KDRV = !MONREQ", "!KDRV = I8K27*!MONREQ");
  await save(document);
  assert.match(shown.document.text, /m\[KDRV\] = [^\n]*I8K27/, "kept in sync");
  await type(document, "!KDRV = I8K27*", "!KDRV = = I8K27*");
  await save(document);
  assert.match(shown.document.text, /^\/\/ Not up to date/);
  await type(document, "!KDRV = = I8K27*", "!KDRV = I8K27*");
  await save(document);
  assert.match(shown.document.text, /m\[KDRV\] = /);
  assert.ok(!shown.document.text.startsWith("// Not up"));
}

async function pages() {
  await vscode.commands.executeCommand("plcxx.ladder");
  const ladder = recorded.panels.at(-1);
  checkPolicy(ladder.webview.html);
  assert.match(ladder.webview.html, /<svg[\s\S]*KDRV/);
  assert.equal(ladder.options.enableScripts, false);
  recorded.settings.set("plcxx.diffTime", "20s");
  await vscode.commands.executeCommand("plcxx.diff", "HEAD");  // fast.plc differs from it since cppBeside()
  const diff = recorded.panels.at(-1);
  assert.equal(diff.type, "plcxx.diff", JSON.stringify(recorded.errors));
  checkPolicy(diff.webview.html);
  assert.match(diff.webview.html, /KDRV/);
  const errors = recorded.errors.length;
  await vscode.commands.executeCommand("plcxx.diff", "no-such-revision");
  assert.match(recorded.errors[errors], /not compared: .*no-such-revision/);
}

async function others() {
  await vscode.commands.executeCommand("plcxx.live");
  assert.match([...recorded.warnings, ...recorded.terminals.map((one) => one.name)].join(), /'live'|Live: lathe/);
  const provider = recorded.taskProviders.get("plcxx");
  const offered = await provider.provideTasks();
  const check = offered.find((task) => task.definition.command === "check");
  assert.deepEqual(check.problemMatchers, ["$plcxx"]);
  const ran = execFileSync(check.execution.process, check.execution.args, { cwd: check.execution.options.cwd, stdio: "pipe" });
  assert.equal(ran.toString(), "");
  assert.equal(provider.resolveTask({ definition: { type: "plcxx", command: "test" } }).execution.args[0], "test");
  assert.equal(provider.resolveTask({ definition: { type: "plcxx" } }), undefined);
  await open("notes.txt");
  await vscode.commands.executeCommand("plcxx.ladder");
  assert.match(recorded.information.at(-1), /part of no program/);
}

async function notFound() {
  const errors = recorded.errors.length;
  recorded.settings.set("plcxx.path", "/no/such/plcxx");
  await event("onDidChangeConfiguration").fire({ affectsConfiguration: (name) => name === "plcxx.path" || name === "plcxx" });
  assert.equal(recorded.errors.length, errors + 1, "said once");
  assert.match(recorded.errors.at(-1), /'\/no\/such\/plcxx' cannot be started.*setting 'plcxx\.path'/);
}

async function main() {
  fs.cpSync(path.join(project, "samples", "nc110", "lathe_16k20"), folder, { recursive: true });
  fs.writeFileSync(path.join(folder, "notes.txt"), "nothing\n");
  const git = (...args) => execFileSync("git", ["-C", folder, "-c", "user.name=t", "-c", "user.email=t@t", ...args], { stdio: "pipe" });
  git("init", "-q");
  git("add", "-A");
  git("commit", "-q", "-m", "as it was");
  recorded.folder = folder;
  recorded.settings.set("plcxx.path", plcxx);
  await extension.activate(context);
  for (const part of [languageServer, scenarios, cppBeside, pages, others, notFound]) {
    await part();
    console.log(`${part.name}: as it should be`);
  }
  await extension.deactivate();
}

main()
  .then(() => 0, (error) => { console.error(error); return 1; })
  .then((code) => { fs.rmSync(folder, { recursive: true, force: true }); process.exit(code); });
