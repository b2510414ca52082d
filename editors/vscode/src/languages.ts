// The languages that this extension colours and that plcxx understands.

/** Names of dialects: language ids of VS Code, and what `plcxx --dialect` takes. */
export const DIALECTS = ["nc110", "host50", "prostep", "technol", "hnc", "classicladder"] as const;

/** A program whose language is not known yet: three of them share the extension ".plc". */
export const UNDECIDED = "plc";

export const LANGUAGES: readonly string[] = [...DIALECTS, UNDECIDED];

/** Files that plcxx reads by these names without being languages of their own. */
const INCLUDED = /\.(inc|h)$/i;

export function isDialect(name: string): boolean {
  return (DIALECTS as readonly string[]).includes(name);
}

/** Is it worth asking the server which language a file has? */
export function mayBeOfAProgram(path: string, languageId: string): boolean {
  return languageId === UNDECIDED || (!isDialect(languageId) && INCLUDED.test(path));
}
