// Runs plcxx as a command. Knows nothing of the editor.
import { spawn } from "node:child_process";

export interface Ran {
  exitCode: number;
  stdout: string;
  stderr: string;
}

/** plcxx cannot be started; the message says what to do. */
export class NotFound extends Error {
  constructor(executable: string, cause: string) {
    super(
      `plcxx was not found: '${executable}' cannot be started (${cause}). Install plcxx and put it into PATH, ` +
        `or name the program in the setting 'plcxx.path'.`);
    this.name = "NotFound";
  }
}

export class Cancelled extends Error {
  constructor() {
    super("cancelled");
    this.name = "Cancelled";
  }
}

/** Exit codes of plcxx from here on are a wrong command line or a fault of its own. */
export const WRONG_USE = 2;

const MAX_OUTPUT_BYTES = 64 << 20;

/** Throws NotFound and Cancelled; another exit code than 0 is the caller's to judge. */
export function runPlcxx(executable: string, args: readonly string[], folder: string, signal?: AbortSignal): Promise<Ran> {
  return new Promise((resolve, reject) => {
    if (signal?.aborted) return reject(new Cancelled());
    const child = spawn(executable, args, { cwd: folder, signal, stdio: ["ignore", "pipe", "pipe"], windowsHide: true });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    let bytes = 0;
    const keep = (into: Buffer[]) => (data: Buffer) => {
      bytes += data.length;
      if (bytes > MAX_OUTPUT_BYTES) child.kill();
      else into.push(data);
    };
    child.stdout.on("data", keep(out));
    child.stderr.on("data", keep(err));
    child.on("error", (error: NodeJS.ErrnoException) => {
      if (error.name === "AbortError") reject(new Cancelled());
      else reject(new NotFound(executable, error.code === "ENOENT" ? "there is no such program" : error.message));
    });
    child.on("close", (code, ended) => {
      resolve({
        exitCode: code ?? 3,
        stdout: Buffer.concat(out).toString("utf8"),
        stderr: Buffer.concat(err).toString("utf8") + (code === null ? `plcxx was ended by ${ended}\n` : ""),
      });
    });
  });
}

/** The first error of plcxx's messages, for a line in the editor. */
export function firstError(stderr: string): string {
  const lines = stderr.split("\n").filter((line) => line.trim() !== "");
  return lines.find((line) => /\berror\b/.test(line)) ?? lines[0] ?? "plcxx said nothing";
}
