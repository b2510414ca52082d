"""A copy of the project that a test may change, and what the compiler says of it.

Not its job: what is changed there.
"""
import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
# GCC takes what it does not know of -Wno-, Clang when it is told to; as cmake/PlcxxTargets.cmake has them for each.
WARNINGS = ["-Wno-unknown-warning-option", "-Wno-deprecated-declarations", "-Wall", "-Wextra", "-Wshadow", "-Wconversion",
            "-Wno-sign-conversion", "-Wno-missing-field-initializers", "-Wno-restrict", "-Werror"]


def copy_to(directory):
    """The project's files in a directory that was empty or not there."""
    if directory.exists():
        shutil.rmtree(directory)
    shutil.copytree(ROOT, directory, ignore=left_out)
    return directory


def left_out(folder, names):
    at_top = pathlib.Path(folder) == ROOT
    return [name for name in names
            if name in (".git", "__pycache__") or at_top and name.startswith(("build", ".cache"))]


def check_sources(compiler, tree, sources):
    """What the compiler says of sources of the copy, as one unit; empty: nothing."""
    unit = tree / "build_checked.cc"
    unit.write_text("".join(f'#include "{source}"\n' for source in sources))
    done = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", *WARNINGS, f"-I{tree}", str(unit)],
                          capture_output=True, text=True)
    unit.unlink()
    return done.stderr if done.returncode != 0 else ""


def build_copy(compiler, tree, *targets):
    """Configures the copy for a compiler and builds targets there; what went wrong, or nothing."""
    build = tree / "build"
    for command in (["cmake", "-S", tree, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                     "-DCMAKE_BUILD_TYPE=Release", "-DPLCXX_TESTS=ON"],
                    ["ninja", "-C", build, *targets]):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            return (done.stdout + done.stderr)[-4000:]
    return ""
