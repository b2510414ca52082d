// Scenarios in the test explorer: found as `plcxx test` finds them, run by it, failures shown where they are.
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import * as vscode from "vscode";

import { Commands } from "./commands";
import { isScenario, readJunit, Result, titleOf } from "./scenarios";
import { firstError } from "./tool";

const FILES = "**/*.yaml";

export class TestExplorer implements vscode.Disposable {
  private readonly controller = vscode.tests.createTestController("plcxx", "plcxx scenarios");
  private readonly subscriptions: vscode.Disposable[] = [];

  constructor(private readonly commands: Commands) {
    this.controller.resolveHandler = async (item) => {
      if (item === undefined) await this.findAll();
    };
    this.controller.refreshHandler = () => this.findAll();
    const profile = this.controller.createRunProfile("Run", vscode.TestRunProfileKind.Run,
      (request, token) => this.run(request, token), true);
    const watcher = vscode.workspace.createFileSystemWatcher(FILES);
    watcher.onDidCreate((uri) => this.look(uri));
    watcher.onDidChange((uri) => this.look(uri));
    watcher.onDidDelete((uri) => this.remove(uri));
    this.subscriptions.push(this.controller, profile, watcher);
  }

  dispose(): void {
    this.subscriptions.forEach((one) => one.dispose());
  }

  async findAll(): Promise<void> {
    const files = await vscode.workspace.findFiles(FILES, "**/node_modules/**");
    const known = new Set(files.map((uri) => uri.toString()));
    for (const item of this.leaves(this.controller.items)) {
      if (item.uri && !known.has(item.uri.toString())) this.remove(item.uri);
    }
    for (const uri of files.sort((a, b) => (a.fsPath < b.fsPath ? -1 : 1))) await this.look(uri);
  }

  private async look(uri: vscode.Uri): Promise<void> {
    let text: string;
    try {
      text = Buffer.from(await vscode.workspace.fs.readFile(uri)).toString("utf8");
    } catch {
      return this.remove(uri);
    }
    const inWorkspace = vscode.workspace.asRelativePath(uri, false);
    if (!isScenario(inWorkspace, text)) return this.remove(uri);
    const folder = this.folderItem(uri);
    const item = this.controller.createTestItem(uri.toString(), inWorkspace.split("/").pop() ?? inWorkspace, uri);
    item.description = titleOf(text);
    folder.children.add(item);
  }

  private folderItem(uri: vscode.Uri): vscode.TestItem {
    const folder = vscode.Uri.file(dirname(uri.fsPath));
    const known = this.controller.items.get(folder.toString());
    if (known !== undefined) return known;
    const item = this.controller.createTestItem(folder.toString(), vscode.workspace.asRelativePath(folder, true), folder);
    this.controller.items.add(item);
    return item;
  }

  private remove(uri: vscode.Uri): void {
    const id = vscode.Uri.file(dirname(uri.fsPath)).toString();
    const folder = this.controller.items.get(id);
    folder?.children.delete(uri.toString());
    if (folder !== undefined && folder.children.size === 0) this.controller.items.delete(id);
  }

  private leaves(items: vscode.TestItemCollection): vscode.TestItem[] {
    const all: vscode.TestItem[] = [];
    items.forEach((item) => {
      if (item.children.size === 0) all.push(item);
      else all.push(...this.leaves(item.children));
    });
    return all;
  }

  private async run(request: vscode.TestRunRequest, token: vscode.CancellationToken): Promise<void> {
    const excluded = new Set(request.exclude ?? []);
    const wanted: vscode.TestItem[] = [];
    const add = (item: vscode.TestItem): void => {
      if (excluded.has(item)) return;
      if (item.children.size > 0) item.children.forEach(add);
      else if (!wanted.includes(item)) wanted.push(item);
    };
    if (request.include !== undefined) request.include.forEach(add);
    else this.controller.items.forEach(add);
    const run = this.controller.createTestRun(request);
    // Each folder by itself: its plcxx.yaml counts, and results come while the others run.
    const folders = new Map<string, vscode.TestItem[]>();
    for (const item of wanted) {
      run.enqueued(item);
      const folder = dirname(item.uri!.fsPath);
      folders.set(folder, [...(folders.get(folder) ?? []), item]);
    }
    try {
      for (const [folder, items] of folders) {
        if (token.isCancellationRequested) items.forEach((item) => run.skipped(item));
        else await this.runFolder(run, folder, items, token);
      }
    } finally {
      run.end();
    }
  }

  private async runFolder(run: vscode.TestRun, folder: string, items: vscode.TestItem[], token: vscode.CancellationToken): Promise<void> {
    items.forEach((item) => run.started(item));
    const engine = vscode.workspace.getConfiguration("plcxx", items[0].uri).get<string>("testEngine", "all");
    const temporary = await mkdtemp(join(tmpdir(), "plcxx-"));
    try {
      const junit = join(temporary, "results.xml");
      const names = items.map((item) => item.uri!.fsPath);
      const ran = await this.commands.run(["test", "--engine", engine, "--junit", junit, ...names], folder, token);
      if (ran === undefined) return items.forEach((item) => run.skipped(item));
      run.appendOutput((ran.stdout + ran.stderr).replace(/\r?\n/g, "\r\n"));
      const results = new Map<string, Result>();
      try {
        for (const result of readJunit(await readFile(junit, "utf8"))) results.set(resolve(folder, result.name), result);
      } catch {
        // Nothing was run; plcxx has said why.
      }
      for (const item of items) this.report(run, folder, item, results.get(item.uri!.fsPath), firstError(ran.stderr));
    } finally {
      await rm(temporary, { recursive: true, force: true });
    }
  }

  private report(run: vscode.TestRun, folder: string, item: vscode.TestItem, result: Result | undefined, otherwise: string): void {
    if (result?.outcome === "passed") return run.passed(item);
    const message = new vscode.TestMessage(result?.text ?? otherwise);
    if (result?.expected !== undefined) message.expectedOutput = result.expected;
    if (result?.found !== undefined) message.actualOutput = result.found;
    const place = result?.place;
    message.location = place === undefined
      ? new vscode.Location(item.uri!, new vscode.Position(0, 0))
      : new vscode.Location(vscode.Uri.file(resolve(folder, place.path)), new vscode.Position(place.line, place.column));
    if (result?.outcome === "failed") run.failed(item, message);
    else run.errored(item, message);
  }
}
