// What the extension and its language client use of the module `vscode`, without an editor: documents are kept, what is
// registered and shown is recorded. Everything else of the module is there and does nothing.
const fs = require("node:fs");
const path = require("node:path");
const { fileURLToPath, pathToFileURL } = require("node:url");

class Disposable {
  constructor(dispose) { this.call = dispose; }
  dispose() { this.call?.(); this.call = undefined; }
  static from(...all) { return new Disposable(() => all.forEach((one) => one.dispose())); }
}

class EventEmitter {
  constructor() {
    this.listeners = [];
    this.event = (listener, self, disposables) => {
      const bound = self === undefined ? listener : listener.bind(self);
      this.listeners.push(bound);
      const subscription = new Disposable(() => { this.listeners = this.listeners.filter((one) => one !== bound); });
      disposables?.push(subscription);
      return subscription;
    };
  }
  fire(value) { return Promise.all([...this.listeners].map((listener) => listener(value))); }
  dispose() { this.listeners = []; }
}

class Uri {
  constructor(scheme, authority, uriPath, query) { Object.assign(this, { scheme, authority, path: uriPath, query, fragment: "" }); }
  static file(file) { return Uri.parse(pathToFileURL(file).href); }
  static parse(text) {
    const [, scheme, authority, uriPath, query] = /^([a-z-]+):(?:\/\/([^/?]*))?([^?]*)(?:\?(.*))?$/.exec(text);
    return new Uri(scheme, authority ?? "", decodeURIComponent(uriPath), decodeURIComponent(query ?? ""));
  }
  get fsPath() { return this.scheme === "file" ? fileURLToPath(this.toString()) : this.path; }
  with(change) { return Object.assign(new Uri(), this, change); }
  toString() {
    if (this.scheme === "file") return pathToFileURL(this.path).href;
    return `${this.scheme}:${this.path}${this.query ? "?" + encodeURIComponent(this.query) : ""}`;
  }
  toJSON() { return this.toString(); }
}

class Position {
  constructor(line, character) { Object.assign(this, { line, character }); }
}
class Range {
  constructor(a, b, c, d) {
    [this.start, this.end] = c === undefined ? [a, b] : [new Position(a, b), new Position(c, d)];
  }
}
class Selection extends Range {
  constructor(a, b) { super(a, b); this.active = b; this.anchor = a; }
}
class Location {
  constructor(uri, range) { Object.assign(this, { uri, range: range instanceof Position ? new Range(range, range) : range }); }
}
class Diagnostic {
  constructor(range, message, severity) { Object.assign(this, { range, message, severity }); }
}
class Hover {
  constructor(contents, range) { Object.assign(this, { contents: Array.isArray(contents) ? contents : [contents], range }); }
}
class MarkdownString {
  constructor(value = "") { this.value = value; }
  appendMarkdown(text) { this.value += text; return this; }
  appendText(text) { this.value += text; return this; }
  appendCodeblock(text) { this.value += text; return this; }
}
class TestMessage {
  constructor(message) { this.message = message; }
}
class CodeActionKind {
  constructor(value) { this.value = value; }
  append(part) { return new CodeActionKind(this.value === "" ? part : `${this.value}.${part}`); }
}
for (const [name, value] of Object.entries({ Empty: "", QuickFix: "quickfix", Refactor: "refactor", Source: "source",
  RefactorExtract: "refactor.extract", RefactorInline: "refactor.inline", RefactorRewrite: "refactor.rewrite",
  SourceOrganizeImports: "source.organizeImports" })) CodeActionKind[name] = new CodeActionKind(value);
class CancellationTokenSource {
  constructor() {
    this.emitter = new EventEmitter();
    this.token = { isCancellationRequested: false, onCancellationRequested: this.emitter.event };
  }
  cancel() { this.token.isCancellationRequested = true; this.emitter.fire(); }
  dispose() {}
}
class Task {
  constructor(definition, scope, name, source, execution, problemMatchers) {
    Object.assign(this, { definition, scope, name, source, execution, problemMatchers });
  }
}
class ProcessExecution {
  constructor(process, args, options) { Object.assign(this, { process, args, options }); }
}

class TextDocument {
  constructor(uri, languageId, text) { Object.assign(this, { uri, languageId, text, version: 1, isClosed: false, isDirty: false }); }
  get fileName() { return this.uri.fsPath; }
  get lineCount() { return this.text.split("\n").length; }
  getText() { return this.text; }
  offsetAt(position) {
    const lines = this.text.split("\n");
    return lines.slice(0, position.line).reduce((sum, line) => sum + line.length + 1, 0) + position.character;
  }
}

const recorded = {
  errors: [], warnings: [], information: [], output: [], panels: [], controllers: [], terminals: [],
  commands: new Map(), providers: new Map(), contentProviders: new Map(), taskProviders: new Map(),
  diagnostics: new Map(), settings: new Map(), folder: undefined, decorations: new Map(),
};
const events = {};
const event = (name) => (events[name] ??= new EventEmitter());

/** Members that nobody wrote here: events that never come, registrations that are kept, and functions without effect. */
function complete(members) {
  return new Proxy(members, {
    get(target, name) {
      if (name in target || typeof name !== "string") return target[name];
      if (/^on(Did|Will)/.test(name)) return event(name).event;
      if (/^register.*Provider$/.test(name)) {
        return (first, second) => {
          const provider = second ?? first;
          recorded.providers.set(name, provider);
          return new Disposable(() => recorded.providers.delete(name));
        };
      }
      return undefined;
    },
  });
}

const documents = [];
function languageOf(uri) {
  const extension = path.extname(uri.path).toLowerCase();
  return { ".plc": "plc", ".sym": "nc110", ".il": "host50", ".cld": "hnc", ".clp": "classicladder", ".pst": "prostep", ".tch": "technol", ".cpp": "cpp", ".yaml": "yaml",
           ".h": "c" }[extension] ?? "plaintext";
}
function matches(selector, document) {
  return [selector].flat().some((one) => {
    if (typeof one === "string") return one === document.languageId;
    if (one.language && one.language !== document.languageId) return false;
    if (one.scheme && one.scheme !== document.uri.scheme) return false;
    return !one.pattern || document.uri.path.endsWith(one.pattern.replace("**", ""));
  });
}
function filesBelow(folder) {
  return fs.readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const file = path.join(folder, entry.name);
    return entry.isDirectory() ? (entry.name === ".git" ? [] : filesBelow(file)) : [file];
  });
}

class Collection {
  constructor() { this.map = new Map(); }
  get size() { return this.map.size; }
  add(item) { this.map.set(item.id, item); }
  get(id) { return this.map.get(id); }
  delete(id) { this.map.delete(id); }
  forEach(call) { for (const item of this.map.values()) call(item, this); }
  [Symbol.iterator]() { return this.map[Symbol.iterator](); }
}

const workspace = complete({
  textDocuments: documents,
  get workspaceFolders() {
    return recorded.folder && [{ uri: Uri.file(recorded.folder), name: path.basename(recorded.folder), index: 0 }];
  },
  getWorkspaceFolder: () => workspace.workspaceFolders?.[0],
  getConfiguration: (section) => ({
    get: (name, otherwise) => recorded.settings.get(section ? `${section}.${name}` : name) ?? otherwise,
    inspect: () => undefined,
  }),
  createFileSystemWatcher: () => {
    const emitters = [new EventEmitter(), new EventEmitter(), new EventEmitter()];
    return { onDidCreate: emitters[0].event, onDidChange: emitters[1].event, onDidDelete: emitters[2].event, dispose() {} };
  },
  findFiles: async (glob) => filesBelow(recorded.folder)
    .filter((file) => glob.startsWith("**/*.") ? file.endsWith(glob.slice(4)) : path.basename(file) === glob.slice(3))
    .map((file) => Uri.file(file)),
  asRelativePath: (uri) => path.relative(recorded.folder, uri.fsPath ?? uri) || path.basename(recorded.folder),
  fs: { readFile: async (uri) => fs.readFileSync(uri.fsPath) },
  registerTextDocumentContentProvider: (scheme, provider) => {
    recorded.contentProviders.set(scheme, provider);
    provider.onDidChange((uri) => {
      const document = documents.find((one) => one.uri.toString() === uri.toString());
      if (document) document.text = provider.provideTextDocumentContent(uri);
    });
    return new Disposable();
  },
  openTextDocument: async (uri) => {
    const known = documents.find((one) => one.uri.toString() === uri.toString());
    if (known) return known;
    const text = uri.scheme === "file" ? fs.readFileSync(uri.fsPath, "utf8")
                                       : recorded.contentProviders.get(uri.scheme).provideTextDocumentContent(uri);
    const document = new TextDocument(uri, languageOf(uri), text);
    documents.push(document);
    await event("onDidOpenTextDocument").fire(document);
    return document;
  },
});

const window = complete({
  visibleTextEditors: [],
  activeTextEditor: undefined,
  tabGroups: complete({ all: [] }),
  createOutputChannel: (name) => ({
    name, append: (text) => recorded.output.push(text), appendLine: (text) => recorded.output.push(text + "\n"),
    show() {}, clear() {}, dispose() {}, replace() {}, hide() {},
  }),
  showErrorMessage: async (text) => { recorded.errors.push(text); },
  showWarningMessage: async (text) => { recorded.warnings.push(text); },
  showInformationMessage: async (text) => { recorded.information.push(text); },
  withProgress: (_, task) => task({ report() {} }, new CancellationTokenSource().token),
  createTextEditorDecorationType: () => ({ dispose() {} }),
  createTerminal: (options) => { recorded.terminals.push(options); return { show() {} }; },
  showTextDocument: async (document) => {
    const start = new Position(0, 0);
    const editor = {
      document, selection: new Selection(start, start), revealRange() {},
      setDecorations: (_, ranges) => recorded.decorations.set(document.uri.toString(), ranges),
    };
    window.visibleTextEditors.push(editor);
    return editor;
  },
  createWebviewPanel: (type, title, column, options) => {
    const disposed = new EventEmitter();
    const panel = { type, title, options, webview: { html: "" }, onDidDispose: disposed.event, dispose: () => disposed.fire() };
    recorded.panels.push(panel);
    return panel;
  },
});

const languages = complete({
  match: (selector, document) => (matches(selector, document) ? 10 : 0),
  setTextDocumentLanguage: async (document, languageId) => {
    await event("onDidCloseTextDocument").fire(document);
    document.languageId = languageId;
    await event("onDidOpenTextDocument").fire(document);
    return document;
  },
  createDiagnosticCollection: () => ({
    set: (uri, found) => { recorded.diagnostics.set(uri.toString(), found ?? []); event("diagnostics").fire(uri); },
    delete: (uri) => recorded.diagnostics.delete(uri.toString()),
    clear: () => recorded.diagnostics.clear(),
    dispose() {},
  }),
});

const commands = complete({
  registerCommand: (name, run) => {
    if (recorded.commands.has(name)) throw new Error(`command ${name} is there already`);
    recorded.commands.set(name, run);
    return new Disposable(() => recorded.commands.delete(name));
  },
  executeCommand: async (name, ...args) => recorded.commands.get(name)?.(...args),
});

const tests = complete({
  createTestController: (id, label) => {
    const controller = {
      id, label, items: new Collection(), profiles: [], runs: [],
      createTestItem: (itemId, itemLabel, uri) => ({ id: itemId, label: itemLabel, uri, children: new Collection() }),
      createRunProfile: (name, kind, run) => { controller.profiles.push({ name, kind, run }); return new Disposable(); },
      createTestRun: () => {
        const run = { passedItems: [], failedItems: [], erroredItems: [], skippedItems: [], output: "", ended: false,
          enqueued() {}, started() {}, passed: (item) => run.passedItems.push(item),
          failed: (item, message) => run.failedItems.push({ item, message }),
          errored: (item, message) => run.erroredItems.push({ item, message }),
          skipped: (item) => run.skippedItems.push(item),
          appendOutput: (text) => { run.output += text; }, end: () => { run.ended = true; } };
        controller.runs.push(run);
        return run;
      },
      dispose() {},
    };
    recorded.controllers.push(controller);
    return controller;
  },
});

const tasks = complete({
  registerTaskProvider: (type, provider) => { recorded.taskProviders.set(type, provider); return new Disposable(); },
});

const known = {
  version: "1.82.0", Disposable, EventEmitter, Uri, Position, Range, Selection, Location, Diagnostic, Hover, MarkdownString,
  TestMessage, CodeActionKind, CancellationTokenSource, Task, ProcessExecution, CancellationError: class extends Error {},
  workspace, window, languages, commands, tests, tasks,
  env: complete({ language: "en", appName: "stub" }),
  extensions: complete({ all: [], getExtension: () => undefined }),
  l10n: { t: (text) => text },
  DiagnosticSeverity: { Error: 0, Warning: 1, Information: 2, Hint: 3 },
  ProgressLocation: { Window: 10, Notification: 15 },
  TestRunProfileKind: { Run: 1, Debug: 2, Coverage: 3 },
  ViewColumn: { Active: -1, Beside: -2, One: 1 },
  TaskScope: { Global: 1, Workspace: 2 },
  TaskGroup: { Build: "build", Test: "test" },
  TextEditorRevealType: { InCenterIfOutsideViewport: 2 },
};

known.stub = { recorded, event, documents, TextDocument };

/** Classes and enumerations that are only extended, made or named. */
const everything = new Proxy(known, {
  get(target, name) {
    if (!(name in target) && typeof name === "string" && /^[A-Z]/.test(name)) {
      let next = 0;
      target[name] = new Proxy(class { constructor(...args) { this.args = args; } }, {
        get(made, member) {
          if (!(member in made) && typeof member === "string" && /^[A-Z]/.test(member)) made[member] = next++;
          return made[member];
        },
      });
    }
    return target[name];
  },
});
// A bundler copies what a module has itself and keeps its prototype.
module.exports = Object.create(everything);
