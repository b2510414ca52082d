#!/usr/bin/env python3
"""Random changes of generated C++: what `plcxx verify` still proves must do what the unchanged code does.

run.py PLCXX RUNTIME DIRECTORY PROGRAM... [--edits N] [--seed S] [--time 20s] [--only NAME]

PROGRAM is dialect:file, or dialect:file:key=value. Each is emitted and verified with one place of its code changed, on
the way to the compiler. A change that is caught is what should be; one that is proved is judged by executing both codes
on random states. Exit code 0: no difference was seen in anything that was proved. The seeds are fixed.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

NUMBER = re.compile(r"(?<![\w.])(0x[0-9A-F]+|\d+)(?=u?\b)")
OPERATORS = {" < ": [" <= ", " > "], " <= ": [" < "], " > ": [" >= ", " < "], " >= ": [" > "], " == ": [" != "],
             " != ": [" == "], " & ": [" | "], " | ": [" & "], "Add": ["Sub"], "Sub": ["Add"], "break;": [";"],
             "!m[": ["m["], "return;": [";"]}
# What is left out, or does its work later: assignments and calls.
STATEMENT = re.compile(r"^\s+(m\[|result =|\+\+|continue;|step =|(\w+ = )?\w+\(.*\bhost\b).*;$")
LAUNCHER = """#!/usr/bin/env python3
import os, pathlib, subprocess, sys
arguments = sys.argv[1:]
for i, name in enumerate(arguments):
    if name.endswith(".cpp") and os.path.basename(name) == {name!r}:
        pathlib.Path(name).write_text(pathlib.Path({changed!r}).read_text())
sys.exit(subprocess.run(arguments).returncode)
"""
HARNESS = """#include <cstdio>
#include <cstring>
#include <random>
#include <vector>
#include "original/{name}.hpp"
#include "changed/{name}.hpp"
struct Log {{
  std::vector<unsigned long long> told;
  unsigned long long seed = 0;
  unsigned long long Answer() {{
    seed = seed * 6364136223846793005ULL + told.size() + 1442695040888963407ULL;
    return (seed >> 33) % 3 == 0 ? seed >> 40 & 7 : seed >> 32;
  }}
  void Tell(const void* data, size_t size) {{
    unsigned long long hash = 14695981039346656037ULL;
    for (size_t i = 0; i < size; ++i) hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211ULL;
    told.push_back(hash);
  }}
}};
#define PLCXX_HOST(NAMESPACE) \\
  namespace NAMESPACE {{ \\
  struct Host {{ Log log; }}; \\
{functions}  }}
PLCXX_HOST(original)
PLCXX_HOST(changed)
int main() {{
  std::mt19937_64 random({seed});
  static original::State a;
  static changed::State b;
  static_assert(sizeof a == sizeof b);
  std::memset(&a, 0, sizeof a);
  std::memset(&b, 0, sizeof b);
  original::Host one;
  changed::Host other;
  original::init(a, one);
  changed::init(b, other);
  if (one.log.told != other.log.told || std::memcmp(&a, &b, sizeof a) != 0) {{
    std::puts("init");
    return 1;
  }}
  const auto value = [&random] {{
    const unsigned long long r = random();
    switch (r & 7) {{
      case 0: return 0ULL;
      case 1: return ~0ULL;
      case 2: return r >> 60;
      case 3: return r >> 58;
      case 4: return r >> 56;
      default: return r >> 8;
    }}
  }};
  for (int round = 0; round < {rounds}; ++round) {{
{pokes}    one.log.told.clear();
    other.log.told.clear();
    one.log.seed = other.log.seed = random();
    const unsigned long long argument = value();
    (void)argument;
    switch (random() % {count}) {{
{calls}    }}
    if (one.log.told != other.log.told || std::memcmp(&a, &b, sizeof a) != 0) {{
      std::printf("round %d: %s\\n", round, one.log.told != other.log.told ? "calls" : "state");
      for (size_t i = 0; i < sizeof a; ++i) {{
        if (reinterpret_cast<char*>(&a)[i] != reinterpret_cast<char*>(&b)[i]) std::printf("  byte %zu\\n", i);
      }}
      return 1;
    }}
  }}
  return 0;
}}
"""


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, **more)


def body_lines(text):
    """The lines that do something."""
    inside = False
    for number, line in enumerate(text.splitlines()):
        if re.match(r"^[\w\[].*noexcept \{$", line):
            inside = True
        elif line == "}":
            inside = False
        elif inside and line.strip() and not line.strip().startswith("//"):
            yield number, line


def next_statement(lines, number):
    """The line of the next statement of the same block, behind empty lines and comments; None: the block ends."""
    indent = re.match(r"\s*", lines[number]).group()
    for following in range(number + 1, len(lines)):
        line = lines[following]
        if not line.strip() or line.strip().startswith("//"):
            continue
        return following if STATEMENT.match(line) and re.match(r"\s*", line).group() == indent else None
    return None


def change(text, rng):
    """The text with one place changed, and which."""
    lines = text.splitlines()
    places = []
    for number, line in body_lines(text):
        for match in NUMBER.finditer(line):
            places.append((number, match.start(), match.end(), "number"))
        for operator in OPERATORS:
            for match in re.finditer(re.escape(operator), line):
                places.append((number, match.start(), match.end(), operator))
        if STATEMENT.match(line):
            places.append((number, 0, len(line), "line"))
            following = next_statement(lines, number)
            if following is not None:
                places.append((number, 0, following, "order"))
    while True:
        number, begin, end, kind = rng.choice(places)
        line = lines[number]
        if kind == "order":
            if lines[end] == line:
                continue
            lines[number], lines[end] = lines[end], line
            return "\n".join(lines) + "\n", f"line {number + 1}: {line.strip()}  after  {lines[number].strip()}"
        old = line[begin:end]
        if kind == "line":
            new = ""
        elif kind == "number":
            value = int(old, 0)
            new = str(max(0, rng.choice([value + 1, value - 1, value ^ 1, 0, value * 2])))
        else:
            new = rng.choice(OPERATORS[kind])
        if new != old:
            break
    lines[number] = line[:begin] + new + line[end:]
    return "\n".join(lines) + "\n", f"line {number + 1}: {line.strip()}  ->  {lines[number].strip()}"


def host_function(declaration):
    result, name, rest = re.match(r"^([\w:]+) (\w+)\(Host& host(.*)\) noexcept;$", declaration).groups()
    tells = "".join(f" host.log.Tell(&{p}, sizeof {p});" for p in
                    re.findall(r"(?:const State&|const Retentive&|u?int\d+_t|bool|float|double|\w+_kind|fault_code|\w+_code) (\w+)(?=,|$)",
                               rest.lstrip(", ")))
    answer = "" if result == "void" else f" return static_cast<{result}>(host.log.Answer());"
    call = f'host.log.Tell("{name}", {len(name)});{tells}{answer}'
    return f"  {result} {name}(Host& host{rest}) noexcept {{ {call} }} \\\n"


def judge(directory, name, runtime, seed, rounds):
    """What differs; empty: nothing was seen."""
    header = (directory / "original" / f"{name}.hpp").read_text()
    functions = "".join(host_function(line) for line in header.splitlines() if re.match(r"^[\w:]+ \w+\(Host& host.*noexcept;$", line))
    calls, count = "", 0
    for match in re.finditer(r"^(\w+) (\w+)\(State& m(.*), Host& host\) noexcept;$", header, re.MULTILINE):
        _, routine, rest = match.groups()
        if routine == "init":
            continue
        given = "".join(f", static_cast<{kind}>(argument)" for kind in re.findall(r", (\w+) \w+", rest))
        calls += (f"      case {count}: original::{routine}(a{given}, one); changed::{routine}(b{given}, other); break;\n")
        count += 1
    # Only between scans, and where every value is one: flags and words.
    state = re.search(r"^struct State \{\n(.*?)^\};", header, re.MULTILINE | re.DOTALL).group(1)
    pokes = ""
    members = re.findall(r"^  (bool|uint\d+_t) (\w+)\[(\d+)\];$", state, re.MULTILINE)
    retentive = re.search(r"^  uint8_t bytes\[(\d+)\];$", header, re.MULTILINE)
    if retentive and "Retentive retentive;" in state:
        members.append(("uint8_t", "retentive.bytes", retentive.group(1)))
    for kind, member, size in members:
        new = "(value() & 1) != 0" if kind == "bool" else f"static_cast<{kind}>(value())"
        pokes += (f"    for (int i = 0; i < {size}; ++i) {{\n      if (random() % 3 != 0) continue;\n"
                  f"      a.{member}[i] = b.{member}[i] = {new};\n    }}\n")
    text = HARNESS.format(name=name, functions=functions, pokes=pokes, calls=calls, count=count, seed=seed, rounds=rounds)
    (directory / "judge.cc").write_text(text)
    for one in ("original", "changed"):
        for file in (directory / one).glob("*.[hc]pp"):
            file.write_text(re.sub(r"\bnamespace " + name + r"\b", f"namespace {one}", file.read_text()))
    built = run("g++", "-std=c++20", "-O1", "-w", "-I", str(directory), "-I", str(runtime), str(directory / "judge.cc"),
                *[str(f) for one in ("original", "changed") for f in (directory / one).glob("*.cpp")],
                "-o", str(directory / "judge"))
    if built.returncode != 0:
        return "the judge does not compile: " + built.stderr[:2000]
    ran = run(str(directory / "judge"), timeout=120)
    return ran.stdout if ran.returncode != 0 else ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    parser.add_argument("runtime", type=pathlib.Path)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--edits", type=int, default=5)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--time", default="20s")
    parser.add_argument("--rounds", type=int, default=20000)
    options = parser.parse_args()
    options.directory = options.directory.resolve()
    wrong, counts = [], collections.Counter()
    for program in options.programs:
        dialect, source, *sets = program.split(":")
        name = "prog"
        directory = options.directory / (dialect + "_" + pathlib.Path(source).stem)
        shutil.rmtree(directory, ignore_errors=True)
        directory.mkdir(parents=True)
        given = [source, "--dialect", dialect, "--name", name] + [x for one in sets for x in ("--set", one)]
        emitted = run(options.plcxx, "emit", *given, "-o", str(directory / "emitted"))
        if emitted.returncode != 0:
            wrong.append(f"{program}: {emitted.stderr}")
            continue
        whole = (directory / "emitted" / f"{name}.cpp").read_text()
        changed = directory / f"{name}.cpp"
        launcher = directory / "compiler"
        launcher.write_text(LAUNCHER.format(name=f"{name}.cpp", changed=str(changed)))
        launcher.chmod(0o755)
        verify = [options.plcxx, "verify", *given, "--compiler", f"{launcher} clang++-19", "--time", options.time]
        changed.write_text(whole)
        base = run(*verify)
        if base.returncode != 0:
            counts[f"{dialect}: unchanged not proved"] += 1
            print(f"{program}: unchanged: {base.stdout}{base.stderr}"[:600], flush=True)
            continue
        rng = random.Random(f"{program} {options.seed}")
        for edit in range(options.edits):
            text, what = change(whole, rng)
            changed.write_text(text)
            ran = run(*verify)
            said = ran.stdout + ran.stderr
            if ran.returncode not in (0, 1):
                wrong.append(f"{program}: {what}: verify ended with {ran.returncode}: {said}")
                continue
            if ran.returncode == 1:
                kind = "not decided" if "not decided" in said and "differ" not in said else "caught"
                counts[f"{dialect}: {kind}"] += 1
                continue
            for one in ("original", "changed"):
                shutil.rmtree(directory / one, ignore_errors=True)
                shutil.copytree(directory / "emitted", directory / one)
            (directory / "changed" / f"{name}.cpp").write_text(text)
            seen = judge(directory, name, options.runtime, rng.getrandbits(30), options.rounds)
            counts[f"{dialect}: proved" + (", WRONGLY" if seen else "")] += 1
            print(f"{program}: proved: {what}", flush=True)
            if seen:
                wrong.append(f"{program}: {what}: proved, but {seen}")
    for key in sorted(counts):
        print(f"{key}: {counts[key]}")
    for text in wrong:
        print("WRONG", text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
