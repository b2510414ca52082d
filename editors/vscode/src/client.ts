// The language server: one for the window, started with the first file of ours.
import * as vscode from "vscode";
import { LanguageClient, LanguageClientOptions, ServerOptions, State } from "vscode-languageclient/node";

import { isDialect, LANGUAGES, mayBeOfAProgram } from "./languages";
import { ProgramOfFile } from "./program";
import { NotFound, runPlcxx, WRONG_USE } from "./tool";

export function executableOf(): string {
  const path = vscode.workspace.getConfiguration("plcxx").get<string>("path", "plcxx").trim();
  return path === "" ? "plcxx" : path;
}

/** Says what is missing, with the remedy as a button. */
export async function showNotFound(error: NotFound): Promise<void> {
  const settings = "Open settings";
  const chosen = await vscode.window.showErrorMessage(error.message, settings);
  if (chosen === settings) await vscode.commands.executeCommand("workbench.action.openSettings", "plcxx.path");
}

export class Server implements vscode.Disposable {
  private client: LanguageClient | undefined;
  private starting: Promise<void> | undefined;
  private readonly asked = new Set<string>();

  constructor(private readonly output: vscode.OutputChannel) {}

  /** Resolves also when there is no plcxx; that has been said then. */
  start(): Promise<void> {
    this.starting ??= this.startNew();
    return this.starting;
  }

  async restart(): Promise<void> {
    await this.stop();
    await this.start();
  }

  async stop(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    this.starting = undefined;
    this.asked.clear();
    if (client !== undefined && client.state !== State.Stopped) await client.stop();
  }

  dispose(): void {
    void this.stop();
  }

  /** The program of a file; undefined: there is no server, or the file is part of none. */
  async programOf(uri: vscode.Uri): Promise<ProgramOfFile | undefined> {
    await this.start();
    if (this.client === undefined || uri.scheme !== "file") return undefined;
    try {
      const answer = await this.client.sendRequest<ProgramOfFile | null>("plcxx/program", {
        textDocument: { uri: uri.toString() },
      });
      return answer ?? undefined;
    } catch (error) {
      this.output.appendLine(`plcxx/program: ${error instanceof Error ? error.message : String(error)}`);
      return undefined;
    }
  }

  /** A document gets the language of its program, so that it has its colours. */
  async chooseLanguage(document: vscode.TextDocument): Promise<void> {
    if (document.uri.scheme !== "file" || !mayBeOfAProgram(document.uri.fsPath, document.languageId)) return;
    const key = document.uri.toString();
    if (this.asked.has(key)) return;  // the user may have chosen another one since
    this.asked.add(key);
    const program = await this.programOf(document.uri);
    const wanted = vscode.workspace.getConfiguration("plcxx", document.uri).get<string>("dialect", "auto");
    // A project says which language it has; the setting is for files without one.
    const isChosen = isDialect(wanted) && !program?.project && LANGUAGES.includes(document.languageId);
    const dialect = isChosen ? wanted : program?.dialect;
    if (dialect !== undefined && isDialect(dialect)) await vscode.languages.setTextDocumentLanguage(document, dialect);
  }

  forget(document: vscode.TextDocument): void {
    this.asked.delete(document.uri.toString());
  }

  private async startNew(): Promise<void> {
    const executable = executableOf();
    try {
      // The client's own message for a program that is not there names neither it nor the setting.
      const ran = await runPlcxx(executable, ["lsp", "--help"], process.cwd());
      if (ran.exitCode >= WRONG_USE) throw new NotFound(executable, "it has no command 'lsp': it is older than this extension");
    } catch (error) {
      if (!(error instanceof NotFound)) throw error;
      this.output.appendLine(error.message);
      void showNotFound(error);
      return;
    }
    const server: ServerOptions = { command: executable, args: ["lsp"] };
    const options: LanguageClientOptions = {
      documentSelector: [
        ...LANGUAGES.map((language) => ({ scheme: "file", language })),
        { scheme: "file", pattern: "**/plcxx.yaml" },
      ],
      outputChannel: this.output,
      synchronize: {
        fileEvents: vscode.workspace.createFileSystemWatcher(
          "**/{plcxx.yaml,plcxx.baseline,*.plc,*.sym,*.il,*.pst,*.tch,*.cld,*.clp,*.inc,*.h}"),
      },
    };
    const client = new LanguageClient("plcxx", "plcxx", server, options);
    await client.start();
    this.client = client;
  }
}
