// Which program a file belongs to, as `plcxx lsp` answers it, and how the command line names it.
import { dirname } from "node:path";

/** The answer to `plcxx/program`. */
export interface ProgramOfFile {
  dialect: string;
  /** Path of plcxx.yaml; null: no project says it. */
  project: string | null;
  /** Its name in the project. */
  program: string;
  /** Absolute paths. */
  sources: string[];
}

/** Where commands about the program run. */
export function folderOf(program: ProgramOfFile): string {
  return dirname(program.project ?? program.sources[0] ?? ".");
}

/** Arguments that choose the program; sources come last on every command line of plcxx. */
export function argumentsOf(program: ProgramOfFile): { options: string[]; sources: string[] } {
  if (program.project !== null) {
    return { options: ["--project", program.project, "--program", program.program], sources: [] };
  }
  return { options: ["--dialect", program.dialect], sources: program.sources };
}
