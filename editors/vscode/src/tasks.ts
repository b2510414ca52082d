// Tasks: commands of plcxx for the projects of a workspace, their messages as problems.
import { basename, dirname } from "node:path";
import * as vscode from "vscode";

import { executableOf } from "./client";

const TYPE = "plcxx";
const OFFERED = ["check", "test", "emit", "build", "prove"] as const;

interface Definition extends vscode.TaskDefinition {
  command: string;
  arguments?: string[];
}

function taskOf(definition: Definition, scope: vscode.WorkspaceFolder | vscode.TaskScope, name: string, folder?: string): vscode.Task {
  const execution = new vscode.ProcessExecution(executableOf(), [definition.command, ...(definition.arguments ?? [])],
    folder === undefined ? {} : { cwd: folder });
  const matchers = definition.command === "test" ? ["$plcxx", "$plcxx-scenario"] : ["$plcxx"];
  const task = new vscode.Task(definition, scope, name, TYPE, execution, matchers);
  if (definition.command === "test") task.group = vscode.TaskGroup.Test;
  if (definition.command === "check" || definition.command === "build") task.group = vscode.TaskGroup.Build;
  return task;
}

export function registerTasks(): vscode.Disposable {
  return vscode.tasks.registerTaskProvider(TYPE, {
    async provideTasks() {
      const tasks: vscode.Task[] = [];
      for (const project of await vscode.workspace.findFiles("**/plcxx.yaml")) {
        const scope = vscode.workspace.getWorkspaceFolder(project) ?? vscode.TaskScope.Workspace;
        const folder = dirname(project.fsPath);
        for (const command of OFFERED) {
          const definition: Definition = { type: TYPE, command, arguments: ["--all", "--project", project.fsPath] };
          tasks.push(taskOf(definition, scope, `${command} ${basename(folder)}`, folder));
        }
      }
      return tasks;
    },
    resolveTask(task) {
      const definition = task.definition as Definition;
      if (typeof definition.command !== "string") return undefined;
      return taskOf(definition, task.scope ?? vscode.TaskScope.Workspace, task.name);
    },
  });
}
