// Scenario files and the results of `plcxx test --junit`. Knows nothing of the editor.

const PROJECT_FILE = "plcxx.yaml";
/** One of these makes a scenario of a YAML file (transpiler/scenarios/scenario.cc). */
const TESTS = /^(steps|properties|expect_error|warnings)[ \t]*:/m;

/** `plcxx test FOLDER` takes each *.yaml that is no project and not hidden; in a workspace others have YAML, too. */
export function isScenario(path: string, text: string): boolean {
  const parts = path.replace(/\\/g, "/").split("/");
  if (parts[parts.length - 1] === PROJECT_FILE || !path.endsWith(".yaml")) return false;
  return !parts.some((part) => /^\.[^.]/.test(part)) && TESTS.test(text);
}

/** What the scenario calls itself. */
export function titleOf(text: string): string | undefined {
  const name = /^name[ \t]*:[ \t]*(.+?)[ \t]*$/m.exec(text);
  return name === null ? undefined : name[1].replace(/^(["'])(.*)\1$/, "$2");
}

export type Outcome = "passed" | "failed" | "unusable";

export interface Place {
  path: string;
  /** Counted from 0, as the editor does. */
  line: number;
  column: number;
}

export interface Result {
  /** As it was named on the command line. */
  name: string;
  outcome: Outcome;
  text: string;
  /** Where the failure is; none: the text does not say. */
  place?: Place;
  expected?: string;
  found?: string;
}

const ENTITIES: Record<string, string> = { amp: "&", lt: "<", gt: ">", quot: '"', apos: "'" };

function unescaped(text: string): string {
  return text.replace(/&(#x[0-9a-fA-F]+|#\d+|\w+);/g, (whole, name: string) => {
    if (name.startsWith("#x")) return String.fromCodePoint(parseInt(name.slice(2), 16));
    if (name.startsWith("#")) return String.fromCodePoint(parseInt(name.slice(1), 10));
    return ENTITIES[name] ?? whole;
  });
}

/** "turret.yaml:8:12: step 5 ..." */
export function placeOf(text: string): Place | undefined {
  const found = /^(.+?):(\d+):(\d+): /.exec(text);
  if (found === null) return undefined;
  return { path: found[1], line: Math.max(0, Number(found[2]) - 1), column: Math.max(0, Number(found[3]) - 1) };
}

function resultOf(name: string, outcome: Outcome, text: string): Result {
  const values = /expected (.+?) = (.+?), found (.+?)$/m.exec(text);
  return { name, outcome, text, place: placeOf(text), expected: values?.[2], found: values?.[3] };
}

/** In the order of the file. */
export function readJunit(xml: string): Result[] {
  const results: Result[] = [];
  const cases = /<testcase\b([^>]*?)(?:\/>|>([\s\S]*?)<\/testcase>)/g;
  for (let one = cases.exec(xml); one !== null; one = cases.exec(xml)) {
    const name = unescaped(/\bname="([^"]*)"/.exec(one[1])?.[1] ?? "");
    const body = one[2] ?? "";
    const fault = /<(failure|error)\b[^>]*>([\s\S]*?)<\/\1>/.exec(body);
    if (fault === null) results.push({ name, outcome: "passed", text: "" });
    else results.push(resultOf(name, fault[1] === "failure" ? "failed" : "unusable", unescaped(fault[2])));
  }
  return results;
}
