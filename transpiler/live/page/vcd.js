// A waveform from a file (value change dump, IEEE 1364) for the chart: read here, and sent nowhere.

const kMostBytes = 32 << 20;
const kMostSamples = 200000;
const unitMs = { s: 1000, ms: 1, us: 1e-3, ns: 1e-6, ps: 1e-9, fs: 1e-12 };
const typeOf = (width) => (width === 1 ? "bit" : width <= 8 ? "i8" : width <= 16 ? "i16" : width <= 32 ? "i32" : "i64");

function header(text) {
  const end = text.indexOf("$enddefinitions");
  if (end < 0) throw new Error("this is no waveform: it has no $enddefinitions");
  const words = text.slice(0, end).split(/\s+/);
  const scopes = [], variables = [];
  let scale = 1;
  for (let i = 0; i < words.length; ++i) {
    if (words[i] === "$scope") scopes.push(words[i + 2]);
    else if (words[i] === "$upscope") scopes.pop();
    else if (words[i] === "$timescale") {
      const [, number, unit] = /^(\d+)\s*([munpf]?s)$/.exec(words.slice(i + 1, words.indexOf("$end", i)).join("")) ?? [];
      if (!unit) throw new Error("its $timescale cannot be read");
      scale = Number(number) * unitMs[unit];
    } else if (words[i] === "$var") {
      variables.push({ type: typeOf(Number(words[i + 2])), id: words[i + 3], name: words[i + 4], signed: false });
    }
  }
  return { scale, variables, body: text.slice(text.indexOf("$end", end + 1) + 4) };
}

/** What the chart draws: watched locations, at most `most`, and samples [number, ms, values]. */
export function readVcd(text, most) {
  if (text.length > kMostBytes) throw new Error("the file is larger than 32 MB");
  const { scale, variables, body } = header(text);
  const watched = variables.slice(0, most);
  if (watched.length === 0) throw new Error("it has no variables");
  const numbers = new Map();
  watched.forEach((one, i) => numbers.set(one.id, [...(numbers.get(one.id) ?? []), i]));
  const values = watched.map(() => 0), samples = [];
  let ms = 0;
  const keep = () => {
    if (samples.length >= kMostSamples) throw new Error("it has more than 200000 changes");
    if (samples.at(-1)?.[1] === ms) samples.at(-1)[2] = [...values];
    else samples.push([samples.length, ms, [...values]]);
  };
  const set = (id, value) => {
    for (const i of numbers.get(id) ?? []) values[i] = value;
  };
  const number = (bits) => {
    const value = BigInt("0b" + (bits.replace(/[xz]/gi, "0") || "0"));
    return value <= BigInt(Number.MAX_SAFE_INTEGER) ? Number(value) : value.toString();
  };
  for (const line of body.split("\n")) {
    const word = line.trim();
    if (word === "" || word[0] === "$") continue;
    if (word[0] === "#") {
      if (samples.length > 0 || ms > 0 || word !== "#0") keep();
      ms = Math.round(Number(word.slice(1)) * scale);
      if (!Number.isFinite(ms)) throw new Error("'" + word.slice(0, 20) + "' is no time");
    } else if (/^b[01xz]+ /i.test(word)) {
      const [bits, id] = word.slice(1).split(/\s+/);
      set(id, number(bits));
    } else if (/^[01xz]/i.test(word)) {
      set(word.slice(1), word[0] === "1" ? 1 : 0);
    } else if (word[0] !== "r" && word[0] !== "R") {
      throw new Error("'" + word.slice(0, 20) + "' cannot be read");
    }
  }
  keep();
  return { watched, samples };
}
