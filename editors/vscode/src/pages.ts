// Pages of plcxx beside the editor: the ladder of the open program, and what a change does to its outputs.
import { randomBytes } from "node:crypto";
import * as vscode from "vscode";

import { Commands } from "./commands";
import { pictureOf, withPolicy } from "./page";
import { argumentsOf, folderOf, ProgramOfFile } from "./program";
import { WRONG_USE } from "./tool";

function newNonce(): string {
  return randomBytes(16).toString("hex");
}

export class Pages implements vscode.Disposable {
  private readonly ladders = new Map<vscode.WebviewPanel, ProgramOfFile>();
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly commands: Commands) {
    this.subscriptions = [
      vscode.commands.registerCommand("plcxx.ladder", () => this.showLadder()),
      vscode.commands.registerCommand("plcxx.diff", (revision?: string) => this.showDiff(revision)),
      vscode.workspace.onDidSaveTextDocument((document) => this.saved(document)),
    ];
  }

  dispose(): void {
    this.subscriptions.forEach((one) => one.dispose());
  }

  private open(kind: string, title: string): vscode.WebviewPanel {
    return vscode.window.createWebviewPanel(kind, title, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, {
      enableScripts: kind === "plcxx.diff",  // the ladder has none
      enableFindWidget: true,
      localResourceRoots: [],
    });
  }

  private async showLadder(): Promise<void> {
    const open = await this.commands.openProgram();
    if (open === undefined) return;
    const html = await this.ladderOf(open.program);
    if (html === undefined) return;
    const panel = this.open("plcxx.ladder", `Ladder: ${open.program.program}`);
    this.ladders.set(panel, open.program);
    panel.onDidDispose(() => this.ladders.delete(panel));
    panel.webview.html = html;
  }

  private async ladderOf(program: ProgramOfFile): Promise<string | undefined> {
    const { options, sources } = argumentsOf(program);
    const ran = await this.commands.run(["report", "--ladder", ...options, "-o", "-", ...sources], folderOf(program));
    if (ran === undefined) return undefined;
    if (ran.exitCode !== 0) {
      await this.commands.showFailure("no ladder", ran);
      return undefined;
    }
    return withPolicy(pictureOf(`Ladder: ${program.program}`, ran.stdout), newNonce());
  }

  private async saved(document: vscode.TextDocument): Promise<void> {
    for (const [panel, program] of [...this.ladders]) {
      if (!program.sources.includes(document.uri.fsPath)) continue;
      const html = await this.ladderOf(program);
      if (html !== undefined) panel.webview.html = html;
    }
  }

  /** `given`: as the argument of a key binding or a test. */
  private async showDiff(given?: string): Promise<void> {
    const open = await this.commands.openProgram();
    if (open === undefined) return;
    const revision = given ?? (await vscode.window.showInputBox({
      title: "Behavioural diff: the revision to compare with the files as they are saved now",
      value: "HEAD",
      validateInput: (text) => (/^[^\s-][^\s]*$/.test(text) ? undefined : "A revision of git: HEAD, main, v1.2, or A..B"),
    }));
    if (revision === undefined) return;
    const { program } = open;
    const { options, sources } = argumentsOf(program);
    const range = revision.includes("..") ? revision : `${revision}..`;
    const time = vscode.workspace.getConfiguration("plcxx", open.editor.document.uri).get<string>("diffTime", "60s");
    const ran = await this.commands.runWithProgress(`plcxx: comparing with ${revision}`, program,
      ["diff", ...options, "--git", range, "--time", time, "--format", "html", ...sources]);
    if (ran === undefined) return;
    if (ran.exitCode >= WRONG_USE) return this.commands.showFailure("not compared", ran);
    const panel = this.open("plcxx.diff", `Diff: ${program.program} ${range}`);
    panel.webview.html = withPolicy(ran.stdout, newNonce());
  }
}
