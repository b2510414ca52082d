// The colours of the grammars against the words of the language server: comment, keyword, function, number and text have to
// be the same everywhere in the programs that are given.
// usage: colours.cjs PLCXX FILE...        a file's dialect is the folder that it is in: .../nc110/...
const assert = require("node:assert/strict");
const { spawn } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const oniguruma = require("vscode-oniguruma");
const textmate = require("vscode-textmate");
const lsp = require("vscode-languageserver-protocol/node");

const EXTENSION = path.join(__dirname, "..");
const DIALECTS = ["nc110", "host50", "prostep", "technol", "hnc", "classicladder"];
const [plcxx, ...files] = process.argv.slice(2);

async function registryOf() {
  const wasm = fs.readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm"));
  await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  return new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async (scope) => {
      const file = path.join(EXTENSION, "syntaxes", `${scope.replace("source.", "")}.tmLanguage.json`);
      return textmate.parseRawGrammar(fs.readFileSync(file, "utf8"), file);
    },
  });
}

function roleOfScopes(scopes) {
  const scope = scopes.at(-1);
  if (scope.startsWith("comment.")) return "comment";
  if (/^keyword\.(control|other)\./.test(scope)) return "keyword";
  if (scope.startsWith("support.function.")) return "function";
  if (scope.startsWith("constant.numeric.")) return "number";
  if (scope.startsWith("string.")) return "string";
  return "other";
}

/** By line, an array with the role of each character. */
function paintedBy(grammar, lines) {
  let stack = textmate.INITIAL;
  return lines.map((line) => {
    const result = grammar.tokenizeLine(line, stack);
    stack = result.ruleStack;
    const roles = new Array(line.length).fill("other");
    for (const token of result.tokens) roles.fill(roleOfScopes(token.scopes), token.startIndex, Math.min(token.endIndex, line.length));
    return roles;
  });
}

async function tokensOf(connection, legend, file, languageId, text) {
  const uri = pathToFileURL(file).href;
  await connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, { textDocument: { uri, languageId, version: 1, text } });
  const answer = await connection.sendRequest(lsp.SemanticTokensRequest.type, { textDocument: { uri } });
  await connection.sendNotification(lsp.DidCloseTextDocumentNotification.type, { textDocument: { uri } });
  const tokens = [];
  let line = 0;
  let character = 0;
  for (let i = 0; i < (answer?.data.length ?? 0); i += 5) {
    const [lines, characters, length, type] = answer.data.slice(i, i + 4);
    character = lines === 0 ? character + characters : characters;
    line += lines;
    tokens.push({ line, begin: character, end: character + length, type: legend[type] });
  }
  return tokens;
}

async function main() {
  const child = spawn(plcxx, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
  const connection = lsp.createProtocolConnection(new lsp.StreamMessageReader(child.stdout), new lsp.StreamMessageWriter(child.stdin));
  connection.listen();
  const { capabilities } = await connection.sendRequest(lsp.InitializeRequest.type, { processId: null, rootUri: null, capabilities: {} });
  await connection.sendNotification(lsp.InitializedNotification.type, {});
  const legend = capabilities.semanticTokensProvider.legend.tokenTypes;
  const vocabulary = JSON.parse(require("node:child_process").execFileSync(plcxx, ["print", "vocabulary"]));
  const registry = await registryOf();
  const different = [];
  let count = 0;
  for (const file of files) {
    const dialect = DIALECTS.find((name) => file.split(path.sep).includes(name));
    assert.ok(dialect, `${file} is in no folder of a dialect`);
    // As an editor shows it: bytes in the control's code page are letters of some kind.
    const text = new TextDecoder("utf-8").decode(fs.readFileSync(file));
    const lines = text.split(/\r\n|\r|\n/);
    const painted = paintedBy(await registry.loadGrammar(`source.${dialect}`), lines);
    const functions = new Set(Object.keys(vocabulary[dialect].functions).map((name) => name.replace(/ /g, "").toUpperCase()));
    for (const token of await tokensOf(connection, legend, path.resolve(file), dialect, text)) {
      const word = lines[token.line].slice(token.begin, token.end);
      let wanted = ["comment", "keyword", "number", "string"].includes(token.type) ? token.type : "other";
      if (token.type === "function" && functions.has(word.replace(/\s/g, "").toUpperCase())) wanted = "function";
      const roles = new Set(painted[token.line].slice(token.begin, token.end));
      ++count;
      // A routine of the program may have the name of a function.
      if (roles.size === 1 && (roles.has(wanted) || (token.type === "function" && roles.has("function")))) continue;
      different.push(`${file}:${token.line + 1}:${token.begin + 1}: '${word}' is ${token.type} (${wanted}), coloured ${[...roles]}`);
    }
  }
  await connection.sendRequest(lsp.ShutdownRequest.type);
  await connection.sendNotification(lsp.ExitNotification.type);
  different.slice(0, 40).forEach((line) => console.error(line));
  console.log(`${count} words of ${files.length} files, ${different.length} coloured in another way than the language says`);
  assert.ok(count > 0);
  return different.length === 0 ? 0 : 1;
}

main().then((code) => process.exit(code), (error) => { console.error(error); process.exit(1); });
