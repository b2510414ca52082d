// The extension's beginning and end.
import * as vscode from "vscode";

import { Server } from "./client";
import { Commands } from "./commands";
import { CppBeside } from "./cpp_beside";
import { LANGUAGES, mayBeOfAProgram } from "./languages";
import { registerMachineLive } from "./machine_live";
import { Pages } from "./pages";
import { registerTasks } from "./tasks";
import { TestExplorer } from "./test_explorer";

let server: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const output = vscode.window.createOutputChannel("plcxx");
  const own = new Server(output);
  server = own;
  const commands = new Commands(own, output);
  const chooseLanguage = async (document: vscode.TextDocument): Promise<void> => {
    if (mayBeOfAProgram(document.uri.fsPath, document.languageId)) await own.chooseLanguage(document);
    else if (LANGUAGES.includes(document.languageId)) await own.start();
  };
  const explorer = new TestExplorer(commands);
  context.subscriptions.push(
    output, own, explorer, new CppBeside(commands), new Pages(commands), registerMachineLive(commands), registerTasks(),
    vscode.commands.registerCommand("plcxx.restart", () => own.restart()),
    vscode.workspace.onDidOpenTextDocument(chooseLanguage),
    vscode.workspace.onDidChangeConfiguration(async (event) => {
      if (event.affectsConfiguration("plcxx.path")) await own.restart();
    }));
  await Promise.all(vscode.workspace.textDocuments.map(chooseLanguage));
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}
