#!/usr/bin/env python3
"""plcxx soak from the outside: the same bytes, wrong use, what is written, shards and their merge.

commands.py PLCXX ROOT
"""
import filecmp
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

PLCXX, ROOT = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
DOOR = """$
; two valves, and a lock
U4A0 = I0A0
U4A1 = I0A0*I0A1
U4A2 = I0A2*I0A3 + U4A2*/I0A4
T50I(30) = U4A2
U4A3 = T50U
U4A4 = I0A5*/I0A5
"""
# The gate's switches follow from its contactor; both at once is what no machine does.
GATE = """$
U4A0 = I0A0*/I0A6
U4A1 = I0A6*I0A7
U4A2 = I0A6
"""
PLANT = """elements:
- cylinder: {name: gate, extend: U4A0, extend-time: 200 ms, retract-time: 100 ms, extended: I0A6, retracted: I0A7}
"""
PROPERTIES = "never U4A0 and U4A1   # not both\nU4A3 implies U4A2\n"


def soak(folder, *arguments):
    return subprocess.run([PLCXX, "soak", *arguments], cwd=folder, capture_output=True, text=True, timeout=120)


def clean():
    """The environment without what a batch system, which may run this test, says."""
    own = ("SLURM_", "CI_NODE_", "JOB_COMPLETION_", "SHARDS")
    return {**{name: value for name, value in os.environ.items() if not name.startswith(own)}, "PLCXX": PLCXX}


def expect(condition, what, ran=None):
    if not condition:
        raise SystemExit(f"{what}\n" + (f"{ran.args}\nexit code {ran.returncode}\n{ran.stdout}{ran.stderr}" if ran else ""))


def same_folders(one, other):
    names = sorted(str(path.relative_to(one)) for path in one.rglob("*") if path.is_file())
    expect(names == sorted(str(path.relative_to(other)) for path in other.rglob("*") if path.is_file()),
           f"{one} and {other} have other files")
    _, differ, errors = filecmp.cmpfiles(one, other, names, shallow=False)
    expect(not differ and not errors, f"{one} and {other}: {differ} {errors}")
    return names


def with_a_plant(work):
    """Inputs that the plant drives are the plant's: what only chance does is not found, and a finding's scenario has the plant."""
    (work / "gate.plc").write_text(GATE)
    (work / "gate.plant.yaml").write_text(PLANT)
    (work / "both.prop").write_text("never U4A1\n")
    (work / "open.prop").write_text("never U4A2\n")
    (work / "pressed.yaml").write_text("dialect: nc110\nsources: [gate.plc]\nsteps:\n- set: {I0A6: 1, I0A0: 1}\n- run: {slow: 3}\n")
    both = ["gate.plc", "--property", "both.prop", "--for", "10min"]
    expect(soak(work, *both).returncode == 1, "chance closes no two switches")
    planted = soak(work, *both, "--plant", "gate.plant.yaml", "-o", "planted")
    expect(planted.returncode == 0, "the plant closes two switches, or chance still drives them", planted)
    expect("by the plant (gate.plant.yaml), which drives 2 more" in planted.stdout, "the plant is not named", planted)
    record = json.loads((work / "planted" / "soak.json").read_text())
    expect(record["plant"] == "gate.plant.yaml" and record["inputs_of_plant"] == 2, f"the record: {record['plant']}")
    corpus = list((work / "planted").rglob("run-*.yaml"))
    expect(corpus and all("plant: " in run.read_text() and "I0A6" not in run.read_text() for run in corpus), "runs that are kept")
    again = soak(work, *both, "--plant", "gate.plant.yaml", "--jobs", "3", "-o", "planted again")
    expect(again.returncode == 0, "again", again)
    same_folders(work / "planted", work / "planted again")
    found = soak(work, "gate.plc", "--property", "open.prop", "--for", "10min", "--plant", "gate.plant.yaml", "-o", "found")
    expect(found.returncode == 1, "the gate never opens", found)
    scenario = (work / "found" / "property-never-u4a2.yaml").read_text()
    expect("plant: ../gate.plant.yaml" in scenario and "I0A0: 1" in scenario and "I0A6" not in scenario, scenario)
    ran = subprocess.run([PLCXX, "test", "found/property-never-u4a2.yaml"], cwd=work, capture_output=True, text=True)
    expect(ran.returncode == 1 and "never U4A2" in ran.stdout, "the scenario does not show it", ran)
    (work / "other.plant.yaml").write_text(PLANT.replace("U4A0", "U4A5"))
    for plant, words in (("none.yaml", "none.yaml"), ("project", "names no plant"), ("both.prop", "both.prop")):
        wrong = soak(work, *both, "--plant", plant)
        expect(wrong.returncode == 2 and words in wrong.stderr, plant, wrong)
    soak(work, *both, "-o", "without")
    merged = soak(work, "--merge", "merged-plants", "planted", "without")
    expect(merged.returncode == 2 and "another plant" in merged.stderr, "machines of two plants are merged", merged)


# Conditions that chance hardly meets, and a scenario that sets one location twice before time passes.
DEEP = """$
U4A0 = [W0A1=77]*[W0A2=78]*[W0A3=79]
U100K0 = [W0A2=1]*U100K1
U100K1 = [W0A1=77]*[W0A2=78]
"""
TWICE = """dialect: nc110
sources: [deep.plc]
steps:
- set: {W0A1: 77, W0A2: 1}
- set: {W0A2: 78}
- run: {slow: 1}
- power_cycle: {}
"""


def test_passes(work, path, what):
    ran = subprocess.run([PLCXX, "test", path, "--engine", "sim"], cwd=work, capture_output=True, text=True)
    expect(ran.returncode == 0, what, ran)


def what_is_kept(place):
    """Runs that are kept are scenarios that can be read, whatever was there before; what cannot be read is named."""
    work = place / "kept"
    work.mkdir()
    (work / "deep.plc").write_text(DEEP)
    (work / "twice.yaml").write_text(TWICE)
    deep = ["deep.plc", "-o", "deep"]
    soak(work, *deep, "--for", "5min")
    test_passes(work, "deep/corpus", "a kept run sets a location twice in a step")
    reached = json.loads((work / "deep/soak.json").read_text())["reached"]
    (work / "twice.yaml").unlink()
    soak(work, *deep, "--for", "1s", "--seed", "9")
    expect(json.loads((work / "deep/soak.json").read_text())["reached"] == reached, "the runs that were kept are lost")

    # A symbol was renamed: runs of the other version say less, and it is told.
    (work / "gate.sym").write_text("* A gate\nKOPEN = I0A0\nISOPEN = I0A2\nOPEN = U4A0\n")
    (work / "gate.plc").write_text("$\n!OPEN = (!KOPEN + !OPEN)*/!ISOPEN\n")
    gate = ["gate.sym", "gate.plc", "-o", "gate"]
    soak(work, *gate, "--for", "10min")
    expect(any("KOPEN" in run.read_text() for run in (work / "gate/corpus").iterdir()), "no run sets KOPEN")
    for name in ("gate.sym", "gate.plc"):
        (work / name).write_text((work / name).read_text().replace("KOPEN", "KOEFF"))
    ran = soak(work, *gate, "--for", "10min")
    expect("note: runs in 'gate/corpus' set what this program does not have" in ran.stderr and "'KOPEN'" in ran.stderr, "nothing is told", ran)
    test_passes(work, "gate/corpus", "a kept run sets what is no more")

    # What is no scenario is named, and stays.
    (work / "gate/corpus/run-aaaa.yaml").write_text("garbage: [")
    cut = next(path for path in (work / "gate/corpus").iterdir() if path.name != "run-aaaa.yaml")
    cut.write_text(cut.read_text()[:60])
    ran = soak(work, *gate, "--for", "1s")
    for path in (work / "gate/corpus/run-aaaa.yaml", cut):
        expect(f"'gate/corpus/{path.name}' is no run to begin with: " in ran.stderr and path.exists(), path.name, ran)

    # Runs for which there was no time stay for the next time.
    kept = sorted(path.name for path in (work / "deep/corpus").iterdir())
    ran = soak(work, *deep, "--time", "1s", "--for", "1s", "--seed", "3")
    expect(kept == sorted(path.name for path in (work / "deep/corpus").iterdir()), "runs have gone", ran)


def what_is_in_the_way(place):
    """It is told before the hours that would be lost, and a finding takes a free name."""
    work = place / "way"
    work.mkdir()
    (work / "door.plc").write_text(DOOR)
    (work / "door.prop").write_text(PROPERTIES)
    long = ["door.plc", "--property", "door.prop", "--for", "100000h", "--time", "60s"]
    (work / "page").mkdir()
    (work / "page/coverage.html").write_text("mine")
    (work / "corpus").mkdir()
    (work / "corpus/corpus").write_text("a file")
    (work / "file").write_text("a file")
    (work / "read").mkdir()
    for folder, words in (("page", "cannot write 'page/coverage.html': it is there already"), ("corpus", "corpus/corpus"),
                          ("file", "file"), ("/proc/nowhere", "/proc/nowhere")):
        began = time.monotonic()
        ran = soak(work, *long, "-o", folder)
        expect(ran.returncode == 2 and words in ran.stderr and time.monotonic() - began < 30, f"{folder} is not refused at once", ran)
    expect(sorted(path.name for path in work.iterdir()) == ["corpus", "door.plc", "door.prop", "file", "page", "read"], "traces of a refused soak")
    found = "property-never-u4a0-and-u4a1"
    (work / "read" / f"{found}.yaml").write_text("mine")
    ran = soak(work, "door.plc", "--property", "door.prop", "--for", "1min", "-o", "read")
    expect(ran.returncode == 1 and f"read/{found}-2.yaml" in ran.stdout, "a finding has no other name", ran)
    expect((work / "read" / f"{found}.yaml").read_text() == "mine", "a file of the user's is gone")

    # It cannot be written at last, which nobody could know: the result is told all the same.
    (work / "gone.sh").write_text(f'"{PLCXX}" soak door.plc --property door.prop --for 100000h --time 4s -o gone/deep &\n'
                                  "sleep 2; echo x > gone; wait $!\n")
    ran = subprocess.run(["bash", "gone.sh"], cwd=work, capture_output=True, text=True, timeout=120)
    expect(ran.returncode == 2 and "cannot write" in ran.stderr and "never U4A0 and U4A1" in ran.stdout, "the result is not told", ran)


def how_it_ends(place):
    """A signal ends it as its time does, with everything kept; the time counts from the beginning."""
    work = place / "ends"
    work.mkdir()
    (work / "door.plc").write_text(DOOR)
    (work / "door.prop").write_text(PROPERTIES)
    for name, number in (("interrupted", signal.SIGINT), ("ended", signal.SIGTERM)):
        ran = subprocess.Popen([PLCXX, "soak", "door.plc", "--property", "door.prop", "--for", "100000h", "-o", name], cwd=work,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(4)
        ran.send_signal(number)
        time.sleep(0.2)
        ran.send_signal(number)  # as timeout does, which sends it to its child and to the group
        out, errors = ran.communicate(timeout=60)
        expect(ran.returncode == 1 and "never U4A0 and U4A1" in out and "ended by a signal" in out, f"{name}: {ran.returncode}\n{out}{errors}")
        record = json.loads((work / name / "soak.json").read_text())
        expect(record["ended_by_signal"] and not record["ended_by_time"] and record["corpus"], "the record of what was kept")
        expect((work / name / "property-never-u4a0-and-u4a1.yaml").exists(), "the finding is not kept")

    (work / "calm.plc").write_text("$\nU4A0 = I0A0\n")
    ran = subprocess.run([ROOT / "ci/soak/shard.sh", "calm", "calm.plc", "--for", "1min"], cwd=work,
                         env={**clean(), "CI_NODE_INDEX": "1", "CI_NODE_TOTAL": "2"}, capture_output=True, text=True)
    expect(ran.returncode == 0 and "found: nothing" in ran.stdout, "a part that finds nothing", ran)
    # A batch system ends the script.
    ran = subprocess.Popen([ROOT / "ci/soak/shard.sh", "batch", "door.plc", "--for", "100000h"], cwd=work,
                           env={**clean(), "CI_NODE_INDEX": "1", "CI_NODE_TOTAL": "2"}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(4)
    ran.send_signal(signal.SIGTERM)
    out, errors = ran.communicate(timeout=60)
    expect(ran.returncode == 0 and (work / "batch/shard-1/soak.json").exists(), f"the part is lost: {ran.returncode}\n{out}{errors}")

    # What a fleet saw at last is looked at, too.
    (work / "deep.plc").write_text(DEEP)
    ran = soak(work, "door.plc", "--property", "door.prop", "--engine", "fleet", "--for", "100000h", "--time", "20s")
    expect(ran.returncode == 1 and "the time was over" in ran.stdout, "what a fleet saw at last is lost", ran)
    compiler = work / "slow.sh"
    compiler.write_text("#!/bin/sh\nsleep 30\n")
    compiler.chmod(0o755)
    began = time.monotonic()
    ran = soak(work, "door.plc", "--engine", "fleet", "--cxx", "./slow.sh", "--time", "2s")
    expect(ran.returncode == 2 and "--time was over before its code was compiled" in ran.stderr and time.monotonic() - began < 20,
           "the time does not count while the fleet is compiled", ran)


def main():
    with tempfile.TemporaryDirectory() as place:
        work = pathlib.Path(place)
        (work / "door.plc").write_text(DOOR)
        (work / "door.prop").write_text(PROPERTIES)
        door = ["door.plc", "--property", "door.prop"]

        with_a_plant(work)
        what_is_kept(work)
        what_is_in_the_way(work)
        how_it_ends(work)

        # The same bytes, whatever runs at a time, and other ones by another seed.
        first = soak(work, *door, "--for", "20min", "-o", "one")
        expect(first.returncode == 1, "the violated property is no finding", first)
        second = soak(work, *door, "--for", "20min", "-o", "two", "--jobs", "3")
        expect(first.stdout.replace("one/", "two/") == second.stdout, "--jobs changes what is said", second)
        names = same_folders(work / "one", work / "two")
        other = soak(work, *door, "--for", "20min", "--seed", "2")
        expect(other.stdout != first.stdout, "another seed does the same", other)
        expect(not (work / "corpus").exists(), "without -o something is written")

        # Hundreds side by side find it, too, and how many threads there are makes no difference.
        wide = [soak(work, *door, "--engine", "fleet", "--for", "40h", "-o", name, "--jobs", jobs) for name, jobs in (("wide", "1"), ("wide again", "2"))]
        expect(all(one.returncode == 1 and "never U4A0 and U4A1" in one.stdout for one in wide), "a fleet finds nothing", wide[0])
        expect("of 1024 machines" in wide[0].stdout, "the machines of a fleet", wide[0])
        same_folders(work / "wide", work / "wide again")
        for arguments, words in ((["--machines", "700"], "multiple of 512"), (["--shard", "1/4"], "for each of 4 parts"),
                                 (["--cxx", "no-such-compiler"], "no-such-compiler")):
            wrong = soak(work, *door, "--engine", "fleet", *arguments)
            expect(wrong.returncode == 2 and words in wrong.stderr, words, wrong)

        # Sections of host50 have numbers below 0: as plcxx test tells them.
        (work / "turn.il").write_text("SLOW\nNETWORK\n  LD %I1\n  ROT 8, %IW1, %IW2, %W1, M=1\n  OUT %Q0\nEND_SLOW\n")
        turn = soak(work, "turn.il", "--for", "1min")
        expect("fault ROT_RANGE (section -1, network 0)" in turn.stdout, "the section is not named", turn)

        # What was found is a scenario that fails, and the shortest one.
        found = "property-never-u4a0-and-u4a1.yaml"
        expect(found in names and "coverage.html" in names, f"not written: {names}")
        steps = (work / "one" / found).read_text()
        expect("- set: {I0A0: 1, I0A1: 1}\n- run: {slow: 1}\n" in steps, steps)
        tested = subprocess.run([PLCXX, "test", "one/" + found, "--engine", "sim"], cwd=work, capture_output=True, text=True)
        expect(tested.returncode == 1 and "does not hold" in tested.stdout + tested.stderr, "it does not fail", tested)
        kept = [name for name in names if name.startswith("corpus/")]
        ran = subprocess.run([PLCXX, "test", "one/corpus", "--engine", "sim"], cwd=work, capture_output=True, text=True)
        expect(kept and ran.returncode == 0, "a kept run is no scenario that passes", ran)

        # The claim: what was looked at, and what was not reached.
        record = json.loads((work / "one/soak.json").read_text())
        expect(record["machine_ms"] >= 20 * 60_000, "less than what was asked for", first)
        statements = record["coverage"]["statements"]
        expect(statements == {"reached": 6, "of": 6}, f"statements: {statements}")
        expect("door.plc:8" in first.stdout and "one way only" in first.stdout, "what cannot be is not named", first)
        expect("1 of 5 outputs never moved" in first.stdout and "U4A4 (0)" in first.stdout, "outputs", first)
        as_json = soak(work, *door, "--for", "20min", "--format", "json")
        expect(json.loads(as_json.stdout)["reached"] == record["reached"], "--format json says something else", as_json)

        # Runs of earlier times are read again, and none of those that are kept is redundant.
        again = soak(work, *door, "--for", "1s", "-o", "one")
        after = json.loads((work / "one/soak.json").read_text())
        expect(after["reached"] == record["reached"], "what was kept does not reach what was reached", again)
        sets = {name: int(digits[::-1], 16) for name, digits in after["corpus"].items()}
        expect(set(sets) == {path.name for path in (work / "one/corpus").iterdir()}, "files and record differ")
        for name, own in sets.items():
            rest = 0
            for one, goals in sets.items():
                rest |= goals if one != name else 0
            expect(own & ~rest, f"{name} is redundant")

        # Two shards in processes of their own, merged: what both have reached.
        shards = [subprocess.Popen([PLCXX, "soak", *door, "--for", "10min", "--shard", f"{i}/2", "-o", f"shard-{i}"], cwd=work,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for i in (1, 2)]
        for shard in shards:
            shard.communicate()
            expect(shard.returncode == 1, "a shard found nothing")
        merged = soak(work, "--merge", "deep/merged", "shard-1", "shard-2")
        expect(merged.returncode == 1, "the merge lost the finding", merged)
        parts = [json.loads((work / f"shard-{i}/soak.json").read_text()) for i in (1, 2)]
        whole = json.loads((work / "deep/merged/soak.json").read_text())
        for i, digit in enumerate(whole["reached"]):
            expect(int(digit, 16) == int(parts[0]["reached"][i], 16) | int(parts[1]["reached"][i], 16), "coverage of the merge")
        expect(whole["machine_ms"] == sum(part["machine_ms"] for part in parts), "machine-hours of the merge")
        expect(whole["shards"] == ["1/2", "2/2"], f"shards: {whole['shards']}")
        ran = subprocess.run([PLCXX, "test", "deep/merged/corpus", "--engine", "sim", "--allow-outside"], cwd=work,
                             capture_output=True, text=True)
        expect(ran.returncode == 0, "a merged run does not find its program", ran)
        twice = soak(work, "--merge", "never", "shard-1", "shard-1")
        expect(twice.returncode == 2 and "twice" in twice.stderr, "a shard counts twice", twice)

        # The same work without shards is no more work, either; with another seed it is.
        soak(work, *door, "--for", "5min", "-o", "short")
        for other in ("two", "short"):
            ran = soak(work, "--merge", "never", "two", other)
            expect(ran.returncode == 2 and "is there twice (seed 1, 16 machines" in ran.stderr, f"{other} counts again", ran)
        ran = soak(work, "--merge", "both", "two", "one")
        expect(ran.returncode == 1, "a soak that began with other runs is other work", ran)
        soak(work, *door, "--for", "5min", "--seed", "2", "-o", "other-seed")
        ran = soak(work, "--merge", "both", "short", "other-seed")
        expect(ran.returncode == 1 and "of 32 machines" in ran.stdout, "another seed is other work", ran)
        ran = soak(work, "--merge", "never", "both", "other-seed")
        expect(ran.returncode == 2 and "is there twice (seed 2" in ran.stderr, "what was merged counts twice", ran)

        # Two findings of one name are two files, each with its own property.
        for last in ("U4A0", "U4A1"):
            (work / "long.prop").write_text("never " + "U4A0 and " * 8 + last + "\n")
            ran = soak(work, "door.plc", "--property", "long.prop", "--for", "1min", "-o", f"long-{last}")
            expect(ran.returncode == 1, "the property holds", ran)
        ran = soak(work, "--merge", "long", "long-U4A0", "long-U4A1")
        found = [finding["file"] for finding in json.loads((work / "long/soak.json").read_text())["findings"]] if ran.returncode == 1 else []
        expect(len(set(found)) == 2, f"findings of one name: {found}", ran)
        for name, last in zip(found, ("U4A0", "U4A1")):
            expect(f"and {last}\n" in (work / "long" / name).read_text().replace("'", ""), f"{name} is another finding")
        # A run that cannot be read is left out of what is merged.
        for cut in (work / "long-U4A0/corpus").iterdir():
            cut.write_text("garbage: [")
        ran = soak(work, "--merge", "cut", "long-U4A0")
        expect(ran.returncode == 1 and "is left out" in ran.stderr and not list((work / "cut/corpus").iterdir()),
               "a run that cannot be read is merged", ran)

        # The jobs of batch systems, as local processes: each knows its part from another variable.
        scripts = ROOT / "ci/soak"
        for script, own, words in (("shard.sh", {}, "usage: shard.sh FOLDER"), ("merge.sh", {}, "usage: merge.sh FOLDER"),
                                   ("shard.sh out", {}, "set CI_NODE_INDEX and CI_NODE_TOTAL"),
                                   ("shard.sh out", {"CI_NODE_INDEX": "1"}, "set CI_NODE_TOTAL"),
                                   ("shard.sh out", {"JOB_COMPLETION_INDEX": "0"}, "set SHARDS")):
            ran = subprocess.run(f"{scripts}/{script}", shell=True, cwd=work, env={**clean(), **own}, capture_output=True, text=True)
            expect(ran.returncode == 2 and words in ran.stderr, f"{script} is not refused", ran)
        for name, parts in {
                "slurm": [{"SLURM_ARRAY_TASK_ID": str(i), "SLURM_ARRAY_TASK_MIN": "4", "SLURM_ARRAY_TASK_COUNT": "2"} for i in (4, 5)],
                "kubernetes": [{"JOB_COMPLETION_INDEX": str(i), "SHARDS": "2"} for i in (0, 1)],
                "gitlab": [{"CI_NODE_INDEX": str(i), "CI_NODE_TOTAL": "2"} for i in (1, 2)]}.items():
            jobs = [subprocess.Popen([scripts / "shard.sh", name, *door, "--for", "10min"], cwd=work,
                                     env={**clean(), **part}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                    for part in parts]
            for job in jobs:
                said = job.communicate()
                expect(job.returncode == 0, f"{name}: {said}")
            ran = subprocess.run([scripts / "merge.sh", name], cwd=work, env=clean(), capture_output=True, text=True)
            expect(ran.returncode == 1, "the merge tells what was found", ran)
            now = json.loads((work / name / "soak/soak.json").read_text())
            expect(now["reached"] == whole["reached"], f"{name} reaches something else")
        ran = subprocess.run([scripts / "shard.sh", "nobody", *door], cwd=work, env=clean(), capture_output=True, text=True)
        expect(ran.returncode != 0 and "which part" in ran.stderr, "no part is known", ran)

        # Wrong use, each in one line that says what would be right.
        for arguments, words in (
                (["door.plc", "--for", "soon"], "write it as in 100h"),
                (["door.plc", "--for", "0h"], "write it as in 100h"),
                (["door.plc", "--time", "1 s"], "write it as in 60s"),
                (["door.plc", "--shard", "3/2"], "write it as in 2/8"),
                (["door.plc", "--shard", "0/2"], "write it as in 2/8"),
                (["door.plc", "--machines", "2", "--shard", "1/3"], "--machines gives more"),
                (["door.plc", "--property", "nowhere.prop"], "cannot read 'nowhere.prop'"),
                (["--merge", "out"], "name the folders"),
                (["--merge", "out", "nowhere"], "is 'nowhere' a folder that plcxx soak -o wrote"),
                (["--merge", "out", "shard-1", "-o", "x"], "leave -o out"),
                (["nowhere.plc"], "nowhere.plc")):
            ran = soak(work, *arguments)
            expect(ran.returncode in (1, 2) and words in ran.stderr, f"{arguments} is not refused", ran)
        (work / "broken").mkdir()
        for record, words in (('{"plcxx_soak": 1', "it is no record of a soak: this is no JSON"),
                              ("[1]", "it is no record of a soak: a field is missing"),
                              ('{"plcxx_soak": 1, "program": 7}', "it is no record of a soak: a field is missing")):
            (work / "broken/soak.json").write_text(record)
            ran = soak(work, "--merge", "out", "broken")
            expect(ran.returncode == 2 and words in ran.stderr and "exception" not in ran.stderr, "a broken record is not refused", ran)
        for record in ('{"plcxx_soak": 1', "notes of mine"):
            (work / "broken/soak.json").write_text(record)
            ran = soak(work, "door.plc", "--for", "1s", "-o", "broken")
            expect(ran.returncode == 2 and "'broken/soak.json' is not overwritten: it is no record of a soak" in ran.stderr
                   and (work / "broken/soak.json").read_text() == record, "what is no record is overwritten", ran)
        (work / "other.plc").write_text("$\nU4A0 = I0A0\n")
        soak(work, "other.plc", "--for", "1s", "-o", "other")
        ran = soak(work, "--merge", "out", "shard-1", "other")
        expect(ran.returncode == 2 and "of another program" in ran.stderr, "another program is merged", ran)

        # A message that never goes: the program forgets to clear it.
        expect(soak(work, "door.plc", "--for", "1min", "--until", "").returncode in (0, 1), "--until")
    print("all as expected")


if __name__ == "__main__":
    main()
