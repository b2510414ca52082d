// What all commands about the open program share: which program it is, running plcxx, saying what went wrong.
import * as vscode from "vscode";

import { executableOf, Server, showNotFound } from "./client";
import { folderOf, ProgramOfFile } from "./program";
import { Cancelled, firstError, NotFound, Ran, runPlcxx } from "./tool";

export class Commands {
  constructor(private readonly server: Server, private readonly output: vscode.OutputChannel) {}

  /** The program of the editor that is open; undefined: it has been said that there is none. */
  async openProgram(): Promise<{ program: ProgramOfFile; editor: vscode.TextEditor } | undefined> {
    const editor = vscode.window.activeTextEditor;
    const program = editor === undefined ? undefined : await this.server.programOf(editor.document.uri);
    if (editor === undefined || program === undefined) {
      void vscode.window.showInformationMessage(
        "plcxx: the open file is part of no program. Open a source, or name it in 'sources' of plcxx.yaml.");
      return undefined;
    }
    return { program, editor };
  }

  programOf(uri: vscode.Uri): Promise<ProgramOfFile | undefined> {
    return this.server.programOf(uri);
  }

  /** Undefined: it could not be started or was cancelled, which has been said. */
  async run(args: readonly string[], folder: string, token?: vscode.CancellationToken): Promise<Ran | undefined> {
    const cancel = new AbortController();
    const subscription = token?.onCancellationRequested(() => cancel.abort());
    this.output.appendLine(`> plcxx ${args.join(" ")}`);
    try {
      return await runPlcxx(executableOf(), args, folder, cancel.signal);
    } catch (error) {
      if (error instanceof NotFound) void showNotFound(error);
      else if (!(error instanceof Cancelled)) throw error;
      return undefined;
    } finally {
      subscription?.dispose();
    }
  }

  /** With progress and a button that ends it. */
  runWithProgress(title: string, program: ProgramOfFile, args: readonly string[]): Thenable<Ran | undefined> {
    return vscode.window.withProgress(
      { location: vscode.ProgressLocation.Notification, title, cancellable: true },
      (_, token) => this.run(args, folderOf(program), token));
  }

  /** What plcxx said is in the output; a message has its first error. */
  async showFailure(what: string, ran: Ran): Promise<void> {
    this.output.appendLine(ran.stderr);
    const show = "Show output";
    const chosen = await vscode.window.showErrorMessage(`plcxx: ${what}: ${firstError(ran.stderr)}`, show);
    if (chosen === show) this.output.show(true);
  }
}
