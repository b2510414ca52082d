"""A copy of the sources with all mutants in it, build/mutants/source, its binaries, and the table of the mutants."""
import collections
import filecmp
import glob
import hashlib
import os
import pathlib
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACE = ROOT / "build" / "mutants"
SOURCE, TABLE = PLACE / "source", PLACE / "table"
BUILD = SOURCE / "build"  # as that of every checkout: what is not mutated comes from the compiler cache
JUDGED = SOURCE / "judged/hnc"  # scenarios of hnc's other judge: random programs, and what they compute on an AVR
JUDGED_PROGRAMS = 200       # as tests/judges/avr runs them

# What is mutated: a folder's name here, patterns of its files.
FOLDERS = {
    "nc110": ["transpiler/dialects/nc110/lowering/*.cc"],
    "host50": ["transpiler/dialects/host50/lowering/*.cc"],
    "prostep": ["transpiler/dialects/prostep/lowering/*.cc"],
    "technol": ["transpiler/dialects/technol/lowering/*.cc", "transpiler/dialects/technol/analysis/effects.cc"],
    "hnc": ["transpiler/dialects/hnc/lowering/*.cc"],
    "passes": ["transpiler/passes/**/*.cc"],
    "emit": ["transpiler/emit/**/*.cc"],
    "runtime": ["runtime_support/plcxx/*.h"],
    "classicladder": ["transpiler/dialects/classicladder/lowering/*.cc"],
}
# The folders of tests that may see them.
TESTS = ("passes", "emit", "ir", "sim", "runtime_support", "link", "dialects", "golden", "printed", "reference")
# The mutated libraries, whose code is large and runs for moments. What reads beyond the end of a list is to be seen.
LIBRARIES = {"emit": "emit emit_layout emit_legalize emit_print", "runtime": "sim"}  # others are named as their folder
FAST_TO_COMPILE = """
foreach(FOLDER {libraries})
  if(TARGET plcxx_${{FOLDER}})
    target_compile_options(plcxx_${{FOLDER}} PRIVATE -O0 -w -D_GLIBCXX_ASSERTIONS)
  endif()
endforeach()
"""
SEEN_BY_ALL = ("passes", "runtime")  # folders of mutants that tests of every dialect reach
JUDGED_ON_AVR = ("hnc", "emit", *SEEN_BY_ALL)
MOST_OF_FOLDER = 1 << 14  # ids of a folder do not depend on which others are mutated: the compiler cache knows its code


class Mutant:
    """One change. Its key is the same in every build, as long as the code around it is."""

    def __init__(self, folder, line, occurrence_of):
        number, self.file, row, self.function, self.kind, self.text = line.rstrip("\n").split("\t")
        self.id, self.line, self.folder = int(number), int(row), folder
        plain = (self.file, self.function.replace("(anonymous namespace)::", ""), self.kind, self.text)
        occurrence_of[plain] = occurrence_of.get(plain, 0) + 1
        self.key = " | ".join(plain) + (f" | {occurrence_of[plain]}" if occurrence_of[plain] > 1 else "")


def folder_files(folder, root=ROOT):
    found = {name for pattern in FOLDERS[folder] for name in glob.glob(str(root / pattern), recursive=True)}
    return sorted(found)


def concerns(binary, folders):
    """Whether a test's binary has code of the folders in it, directly or as the tool that it runs."""
    lowers = binary.startswith(("dialects", "golden", "printed", "reference"))
    emits = binary.startswith(("emit", "golden", "printed"))
    return any(folder in SEEN_BY_ALL or (emits if folder == "emit" else lowers) for folder in folders)


def read_table(path=TABLE):
    folders = {}
    for folder in FOLDERS:
        for name in folder_files(folder, SOURCE):
            folders[str(pathlib.Path(name).relative_to(SOURCE))] = folder
    counts = {}
    with open(path, encoding="utf-8", errors="replace") as lines:
        return [Mutant(folders.get(line.split("\t")[1], ""), line, counts) for line in lines]


def rewrite(mutate, files, root, out, table, first, includes):
    own_headers = subprocess.run(["clang-19", "-print-resource-dir"], check=True, capture_output=True, text=True).stdout
    subprocess.run([mutate, "--first", str(first), "--out", out, "--table", table, "--root", root, *files, "--",
                    "-std=c++20", "-resource-dir", own_headers.strip(), *[f"-I{folder}" for folder in includes]], check=True)


def copy_changed(source, target):
    """What is the same keeps its time, so that it is not compiled again."""
    if target.exists() and filecmp.cmp(source, target, shallow=False):
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)
    shutil.copymode(source, target)


def write_changed(target, text):
    if not target.exists() or target.read_text() != text:
        target.write_text(text)


def remove_others(names):
    """What is no longer in the project: patterns of CMake would find it."""
    there = set(names)
    for place in ("transpiler", "runtime_support", "tests", "samples", "cmake"):
        for path in (SOURCE / place).rglob("*"):
            if path.is_file() and path.relative_to(SOURCE).as_posix() not in there:
                path.unlink()


def make_sources(mutate, folders):
    rewritten = PLACE / "rewritten"
    shutil.rmtree(rewritten, ignore_errors=True)
    PLACE.mkdir(parents=True, exist_ok=True)
    table = PLACE / "table.new"
    table.unlink(missing_ok=True)
    for number, folder in enumerate(FOLDERS):
        if folder in folders:
            print(f"mutating {folder}", flush=True)
            rewrite(mutate, folder_files(folder), ROOT, rewritten, table, number * MOST_OF_FOLDER + 1,
                    [ROOT, ROOT / "runtime_support"])
    with open(table, encoding="utf-8", errors="replace") as lines:
        counts = collections.Counter((int(line.split("\t")[0]) - 1) // MOST_OF_FOLDER for line in lines)
    assert len(counts) == len(folders), "a folder has no mutants: its files are elsewhere"
    assert max(counts.values()) < MOST_OF_FOLDER, "a folder has more mutants than ids"
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    names = [name for name in listed if name and (ROOT / name).is_file()]
    remove_others(names)
    for name in names:
        # Of the runtime there are both: the simulator has the mutated one, generated code the other.
        changed = rewritten / name
        if changed.exists() and not name.startswith("runtime_support/"):
            copy_changed(changed, SOURCE / name)
        elif name not in ("runtime_support/CMakeLists.txt", "transpiler/CMakeLists.txt"):
            copy_changed(ROOT / name, SOURCE / name)
    for path in (rewritten / "runtime_support").rglob("*.h"):
        copy_changed(path, SOURCE / "mutated_runtime" / path.relative_to(rewritten / "runtime_support"))
    for name in folder_files("runtime"):  # one without a mutant
        path = pathlib.Path(name).relative_to(ROOT / "runtime_support")
        if not (rewritten / "runtime_support" / path).exists():
            copy_changed(name, SOURCE / "mutated_runtime" / path)
    text = (ROOT / "runtime_support/CMakeLists.txt").read_text()
    if "runtime" in folders:
        text = text.replace("${CMAKE_CURRENT_SOURCE_DIR}", "${PROJECT_SOURCE_DIR}/mutated_runtime")
    write_changed(SOURCE / "runtime_support/CMakeLists.txt", text)
    libraries = " ".join(LIBRARIES.get(folder, folder) for folder in folders)
    write_changed(SOURCE / "transpiler/CMakeLists.txt",
                  (ROOT / "transpiler/CMakeLists.txt").read_text() + FAST_TO_COMPILE.format(libraries=libraries))
    os.replace(table, TABLE)


def compiler():
    """That of the checkout: of what another one compiles the cache has nothing."""
    cache = ROOT / "build/CMakeCache.txt"
    found = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$", cache.read_text(), re.M) if cache.exists() else None
    return [f"-DCMAKE_CXX_COMPILER={found[1]}"] if found else []


def build(jobs, folders):
    if not (BUILD / "build.ninja").exists():
        subprocess.run(["cmake", "-G", "Ninja", "-S", SOURCE, "-B", BUILD, *compiler()], check=True, stdout=subprocess.DEVNULL)
    listed = subprocess.run(["ninja", "-C", BUILD, "-t", "targets", "all"], check=True, capture_output=True,
                            text=True).stdout
    targets = [name for name in re.findall(r"^(\w+_test): phony", listed, re.M) if name.startswith(TESTS)]
    targets = [name for name in targets if concerns(name, folders)]
    runner, soak = BUILD / "bin/plcxx_avr_runner", BUILD / "tests/plcxx_soak"
    for_random = [path.name for path, wanted in ((runner, any(folder in JUDGED_ON_AVR for folder in folders)),
                                                 (soak, folders != ["hnc"]))
                  if wanted and re.search(rf"^{path.name}: phony", listed, re.M)]
    subprocess.run(["ninja", "-C", BUILD, "-j", str(jobs), "plcxx", *targets, *for_random], check=True)
    if runner.name in for_random:
        write_judged(runner)
    elif any(folder in JUDGED_ON_AVR for folder in folders):
        print("without the programs that run on an AVR: install avr-gcc and libsimavr (dev/packages)", flush=True)


def write_judged(runner):
    """Written anew when their generator is another one."""
    place = SOURCE / "tests/judges/avr"
    now = hashlib.sha256(b"".join(path.read_bytes() for path in sorted(place.iterdir()) if path.is_file())).hexdigest()
    mark = PLACE / "judged"
    if JUDGED.is_dir() and mark.exists() and mark.read_text() == now:
        return
    print(f"{JUDGED_PROGRAMS} random programs on an AVR, and those written by hand", flush=True)
    # What it says of this build is not asked here: a scenario that fails without a mutant is left out, and reported.
    subprocess.run(["python3", "-B", place / "run.py", BUILD / "bin/plcxx", runner, JUDGED, "--programs",
                    str(JUDGED_PROGRAMS), "--written", "--keep"], check=False, stdout=subprocess.DEVNULL)
    mark.write_text(now)
