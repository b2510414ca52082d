// A session of vscode-languageserver-protocol with plcxx lsp.
const assert = require("node:assert");
const { spawn } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const lsp = require("vscode-languageserver-protocol/node");

async function main() {
  const [plcxx, folder] = process.argv.slice(2);
  const child = spawn(plcxx, ["lsp"]);
  const exited = new Promise((resolve) => child.on("exit", resolve));
  const connection = lsp.createProtocolConnection(
    new lsp.StreamMessageReader(child.stdout), new lsp.StreamMessageWriter(child.stdin));
  const published = new Map();
  const waiting = [];
  connection.onNotification(lsp.PublishDiagnosticsNotification.type, (params) => {
    published.set(params.uri, params);
    waiting.splice(0).forEach((wake) => wake());
  });
  connection.listen();
  const sources = ["lathe.sym", "fast.plc", "spindle.plc", "turret.plc"];
  const options = { iocfil: "IOCFIL", axcfil: "AXCFIL", pgcfil: "PGCFIL", messages: "RUMES5", menu: "LGCMNU", help: "HELP" };
  const { capabilities } = await connection.sendRequest(lsp.InitializeRequest.type, {
    processId: process.pid, rootUri: null, capabilities: {},
    initializationOptions: { programs: [{ base: folder, sources, dialect: "nc110", options }] } });
  assert.equal(capabilities.positionEncoding, "utf-16");
  await connection.sendNotification(lsp.InitializedNotification.type, {});

  const uri = pathToFileURL(path.join(folder, "fast.plc")).href;
  let text = fs.readFileSync(path.join(folder, "fast.plc"), "utf8");
  await connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, {
    textDocument: { uri, languageId: "plc", version: 1, text } });
  const diagnostics = async (version) => {
    while (published.get(uri)?.version !== version) await new Promise((wake) => waiting.push(wake));
    return published.get(uri).diagnostics;
  };
  assert.ok((await diagnostics(1)).every((one) => one.severity !== lsp.DiagnosticSeverity.Error));

  const lines = text.split("\n");
  const line = lines.findIndex((one) => one.startsWith("!KDRV ="));
  const textDocument = { uri };
  const position = { line, character: 2 };
  const hover = await connection.sendRequest(lsp.HoverRequest.type, { textDocument, position });
  assert.match(hover.contents.value, /contactor of the drives/);
  const definition = await connection.sendRequest(lsp.DefinitionRequest.type, { textDocument, position });
  assert.match(definition[0].uri, /lathe\.sym$/);
  const mentions = await connection.sendRequest(lsp.ReferencesRequest.type, {
    textDocument, position, context: { includeDeclaration: true } });
  assert.ok(mentions.length >= 3);
  const renamed = await connection.sendRequest(lsp.RenameRequest.type, { textDocument, position, newName: "KDRIVES" });
  assert.equal(Object.keys(renamed.changes).length, 2);
  const items = await connection.sendRequest(lsp.CompletionRequest.type, { textDocument, position: { line, character: 3 } });
  assert.ok(items.items.some((item) => item.label === "KDRV"));
  const symbols = await connection.sendRequest(lsp.DocumentSymbolRequest.type, { textDocument });
  assert.ok(symbols.length > 0);
  const tokens = await connection.sendRequest(lsp.SemanticTokensRequest.type, { textDocument });
  assert.equal(tokens.data.length % 5, 0);
  await assert.rejects(connection.sendRequest("no/such", {}), /unknown method/);

  await connection.sendNotification(lsp.DidChangeTextDocumentNotification.type, {
    textDocument: { uri, version: 2 },
    contentChanges: [{ range: { start: { line, character: 0 }, end: { line, character: 1 } }, text: "" }] });
  assert.ok((await diagnostics(2)).some((one) => one.severity === lsp.DiagnosticSeverity.Error && one.range.start.line === line));
  await connection.sendRequest(lsp.ShutdownRequest.type);
  await connection.sendNotification(lsp.ExitNotification.type);
  assert.equal(await exited, 0);
  console.log("the client is content");
}

main().then(() => process.exit(0), (error) => { console.error(error); process.exit(1); });
