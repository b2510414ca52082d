// "Machine, live": watches a running machine, where plcxx can.
import * as vscode from "vscode";

import { executableOf } from "./client";
import { Commands } from "./commands";
import { argumentsOf, folderOf } from "./program";

export function registerMachineLive(commands: Commands): vscode.Disposable {
  return vscode.commands.registerCommand("plcxx.live", async () => {
    const open = await commands.openProgram();
    if (open === undefined) return;
    const folder = folderOf(open.program);
    const ran = await commands.run(["live", "--help"], folder);
    if (ran === undefined) return;
    if (ran.exitCode !== 0) {
      const version = await commands.run(["--version"], folder);
      void vscode.window.showWarningMessage(
        `plcxx: a running machine cannot be watched yet: this plcxx (${version?.stdout.trim() ?? "?"}) has no command ` +
          "'live'. Until then 'plcxx sim --watch' shows the program in the simulator.");
      return;
    }
    const { options, sources } = argumentsOf(open.program);
    vscode.window.createTerminal({ name: `Live: ${open.program.program}`, cwd: folder, shellPath: executableOf(),
      shellArgs: ["live", ...options, ...sources] }).show(true);
  });
}
