#!/usr/bin/env python3
"""What `plcxx verify` proves of programs of tests/golden and of the machines in samples/, for each language and target.

table.py PLCXX [--targets host,rv32imac] [--machine-code] [--every N] [--only TEXT] [--samples] [--time 60s] [--reasons]

Of each language it takes each N-th program of tests/golden (with --samples the machine of samples/ instead), builds it for
each target and counts functions: proved, not decided, different. With --machine-code the objects of `plcxx build` are
verified, with the build's own flags, else what Clang makes of the generated code. Seconds are those of the processor, of
plcxx and the compilers that it runs. --reasons lists why functions are not decided, the most frequent reason first.
The exit code is 1 where a function is different or plcxx ends with a fault of its own.
"""
import argparse
import collections
import json
import os
import pathlib
import resource
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "goldens")]
import machine_code_samples  # noqa: E402
import run as goldens  # noqa: E402

ROOT = HERE.parent.parent
LANGUAGES = ("nc110", "technol", "host50", "prostep", "hnc")
TARGETS = ("host", "cortex-m0plus", "cortex-m4", "cortex-m4f", "cortex-m7", "rv32imac", "rv64gc")


def programs(language, options):
    """(folder, words of the command line) of each."""
    if options.samples:
        return [(ROOT / "samples" / name, words.split()) for name, words in machine_code_samples.SAMPLES.items()
                if name.startswith(language + "/")]
    found = {}
    for path in sorted((goldens.GOLDEN / language).rglob("*.yaml")):
        words = goldens.program_of(path)
        if words and options.only in str(path):
            found.setdefault((path.parent, tuple(words)), (path.parent, words))
    return list(found.values())[:: options.every]


def seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def functions_of(plcxx, folder, words, target, options):
    """The functions of one program as its certificate has them; a text where there is none."""
    with tempfile.TemporaryDirectory() as into:
        common = [*words, "--name", "program", "--target", target]
        command = [plcxx, "verify", *common, "--time", options.time, "--front-end", "off", "--certificate",
                   into + "/certificate.json"]
        if options.machine_code:
            built = goldens.run([plcxx, "build", *common, "--quiet", "-o", into], folder, 600)
            libraries = sorted(pathlib.Path(into).glob("*.a"))
            if built is None or not libraries:
                return "not built: " + (built.stderr.strip().splitlines() or [""])[-1] if built else "not built"
            command += ["--object", str(libraries[0])]
        ran = goldens.run(command, folder, 1800)
        if ran is None:
            return "no end within 30 min"
        if ran.returncode not in (0, 1):
            return f"exit code {ran.returncode}: {ran.stderr.strip()[-300:]}"
        certificate = pathlib.Path(into, "certificate.json")
        if not certificate.exists():
            return (ran.stderr.strip().splitlines() or [""])[-1]
        proofs = json.loads(certificate.read_text())
        return proofs["routines"] + proofs.get("functions", [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx")
    parser.add_argument("--targets", default=",".join(TARGETS))
    parser.add_argument("--languages", default=",".join(LANGUAGES))
    parser.add_argument("--machine-code", action="store_true")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--samples", action="store_true")
    parser.add_argument("--time", default="60s")
    parser.add_argument("--reasons", action="store_true")
    options = parser.parse_args()
    plcxx = os.path.abspath(options.plcxx)
    reasons, wrong = collections.Counter(), []
    print(f"{'language':9}{'target':15}{'programs':>9}{'proved':>8}{'not decided':>13}{'different':>11}{'seconds':>9}")
    for language in options.languages.split(","):
        for target in options.targets.split(","):
            counts, of_language, began = collections.Counter(), programs(language, options), seconds()
            refused = 0
            for folder, words in of_language:
                found = functions_of(plcxx, folder, words, target, options)
                if isinstance(found, str):
                    refused += 1
                    reasons[target, found] += 1
                    if found.startswith(("exit code", "no end")):
                        wrong.append(f"{target}, {folder} {' '.join(words)}: {found}")
                    continue
                for proof in found:
                    counts[proof["result"]] += 1
                    if proof["result"] == "different":
                        wrong.append(f"{target}, {folder} {' '.join(words)}: {proof['routine']} is different")
                    if proof["result"] == "not decided":
                        reasons[target, goldens.reason_of(f"{proof['routine']}: not decided: {proof['reason']}")] += 1
            print(f"{language:9}{target:15}{len(of_language) - refused:9}{counts['proved']:8}{counts['not decided']:13}"
                  f"{counts['different']:11}{seconds() - began:9.0f}", flush=True)
    if options.reasons:
        for (target, reason), count in reasons.most_common():
            print(f"{count:5} {target}: {reason}")
    for text in wrong:
        print("WRONG", text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
