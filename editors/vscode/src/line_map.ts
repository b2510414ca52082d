// The C++ of a program as it is shown beside its source, and which line of one belongs to which of the other.
//
// `plcxx emit --line-directives` puts "#line 6 "fast.plc"" in front of each statement. The directives are taken out of
// what is shown.

export interface Place {
  file: string;
  /** Counted from 0, as the editor does. */
  line: number;
}

export interface MappedText {
  text: string;
  /** The source of each line of the text; null: of none. */
  places: (Place | null)[];
}

const DIRECTIVE = /^\s*#line (\d+) "((?:[^"\\]|\\.)*)"\s*$/;

export function readLineMap(cpp: string): MappedText {
  const lines: string[] = [];
  const places: (Place | null)[] = [];
  let place: Place | null = null;
  for (const line of cpp.split("\n")) {
    const directive = DIRECTIVE.exec(line);
    if (directive !== null) {
      const file = directive[2].replace(/\\(.)/g, "$1");
      // What is generated without a statement of its own names the C++ itself.
      place = /\.(cpp|hpp)$/.test(file) ? null : { file, line: Number(directive[1]) - 1 };
      continue;
    }
    // A blank line ends a statement's C++; comments of the next one follow.
    if (line.trim() === "" || /^\S/.test(line)) place = null;
    lines.push(line);
    places.push(place);
  }
  return { text: lines.join("\n"), places };
}

/** The same text below lines of the extension's own. */
export function below(heading: string, mapped: MappedText): MappedText {
  if (heading === "") return mapped;
  const count = heading.split("\n").length;
  return { text: heading + "\n" + mapped.text, places: [...new Array<null>(count).fill(null), ...mapped.places] };
}

function isSameFile(named: string, path: string): boolean {
  const a = named.replace(/\\/g, "/").replace(/^(\.\/)+/, "");
  const b = path.replace(/\\/g, "/");
  return b === a || b.endsWith("/" + a.replace(/^(\.\.\/)+/, ""));
}

/** First and last line of the C++ of the statement at a line of the source, or of the one before it. */
export function cppLinesOf(mapped: MappedText, path: string, line: number): [number, number] | undefined {
  let best: Place | null = null;
  for (const place of mapped.places) {
    if (place === null || !isSameFile(place.file, path) || place.line > line) continue;
    if (best === null || place.line > best.line) best = place;
  }
  if (best === null) return undefined;
  const first = mapped.places.findIndex((place) => place?.file === best.file && place.line === best.line);
  let last = first;
  while (last + 1 < mapped.places.length && mapped.places[last + 1] === mapped.places[first]) ++last;
  return [first, last];
}

/** The source's path and line of a line of the C++. */
export function sourceOf(mapped: MappedText, cppLine: number, sources: readonly string[]): Place | undefined {
  const place = mapped.places[cppLine];
  if (!place) return undefined;
  const file = sources.find((path) => isSameFile(place.file, path)) ?? place.file;
  return { file, line: place.line };
}
