#!/usr/bin/env python3
"""Installs what a build directory holds, and uses it as a machine builder would.

packaging.py BUILD STEP     a step is a function below; exit code 77: a tool that it needs is not there
"""
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "samples" / "cmake_project"


def run(*command, cwd=None, env=None):
    done = subprocess.run([str(word) for word in command], cwd=cwd, env=env, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"FAILED: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def expect(what, found):
    print(("ok: " if found else "FAILED: ") + what, flush=True)
    if not found:
        sys.exit(1)


def need(*tools):
    for tool in tools:
        if shutil.which(tool) is None:
            print(f"skipped: {tool} is not installed")
            sys.exit(77)


def install(build, work):
    run("cmake", "--install", build, "--prefix", work / "prefix")
    return work / "prefix"


def configure(source, binary, *options, env=None):
    run("cmake", "-S", source, "-B", binary, "-G", "Ninja", *options, env=env)


def edit(file, old, new):
    text = file.read_text()
    assert old in text, f"{file}: no '{old}'"
    time.sleep(0.02)  # a newer time for sure
    file.write_text(text.replace(old, new))


class Objects:
    """What a build compiles anew, by the times of its objects."""

    def __init__(self, binary):
        self.binary = binary
        self.times = self.read()

    def read(self):
        return {file.name: file.stat().st_mtime_ns for file in self.binary.rglob("*.o")}

    def rebuilt(self):
        before, self.times = self.times, None
        run("cmake", "--build", self.binary)
        self.times = self.read()
        return sorted(name for name, when in self.times.items() if before.get(name) != when)


def expect_shell_files(prefix):
    for place in ("man/man1/plcxx.1", "man/man1/plcxx-check.1", "bash-completion/completions/plcxx",
                  "zsh/site-functions/_plcxx", "fish/vendor_completions.d/plcxx.fish"):
        file = prefix / "share" / place
        expect(f"share/{place} is installed", file.is_file() and "plcxx" in file.read_text())


def installed(build, work):
    prefix = install(build, work)
    expect_shell_files(prefix)
    project = work / "project"
    shutil.copytree(EXAMPLE, project)
    binary = work / "binary"
    configure(project, binary, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", binary)
    run("ctest", "--test-dir", binary, "--output-on-failure")
    expect("the example builds and passes with the installed package", True)

    expect("nothing to do", "no work to do" in run("cmake", "--build", binary))
    objects = Objects(binary)
    (project / "coolant.plc").touch()
    expect("a newer source with the same text compiles nothing", objects.rebuilt() == [])
    expect("and nothing is left to do", "no work to do" in run("cmake", "--build", binary))
    edit(project / "coolant.plc", "T1I(50)", "T1I(40)")
    expect("an edited statement compiles the program, not what uses it", objects.rebuilt() == ["coolant.cpp.o"])
    edit(project / "MESSAGES", "clogged", "blocked")
    expect("a file that an option names is a dependency", objects.rebuilt() == ["coolant.cpp.o", "main.cpp.o"])
    edit(project / "coolant.sym", "PUMP2 ", "PUMPB ")
    failed = subprocess.run(["cmake", "--build", str(binary)], capture_output=True, text=True)
    expect("a symbol that is gone is an error of the build, at its place",
           failed.returncode != 0 and "coolant.plc:" in failed.stdout + failed.stderr)
    edit(project / "coolant.sym", "PUMPB ", "PUMP2 ")
    expect("back again", objects.rebuilt() in ([], ["coolant.cpp.o", "main.cpp.o"]))

    if shutil.which("ccache"):
        env = dict(os.environ, CCACHE_DIR=str(work / "ccache"))
        place = work / "cached"
        for attempt in ("first", "second"):
            configure(project, place, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache", env=env)
            run("cmake", "--build", place, "--target", "coolant", env=env)
            if attempt == "first":
                shutil.rmtree(place)
        statistics = dict(line.split("\t") for line in run("ccache", "--print-stats", env=env).splitlines() if "\t" in line)
        hits = int(statistics["direct_cache_hit"]) + int(statistics["preprocessed_cache_hit"])
        expect("ccache finds unchanged output again", hits == 1)


HOSTS = """cmake_minimum_required(VERSION 3.25)
project(hosts LANGUAGES CXX)
find_package(plcxx REQUIRED)
set(CMAKE_CXX_FLAGS "-Wall -Wextra -Werror")
plcxx_add_program(lathe PROJECT lathe_16k20/plcxx.yaml HOST linuxcnc)
plcxx_add_program(station SOURCES coolant.sym coolant.plc HOST posix)
add_executable(station_loop io.cpp)
target_link_libraries(station_loop PRIVATE station)
"""
TERMINALS = """#include "plcxx_host/posix.h"

namespace plcxx::host {
bool io_open(int, char**) noexcept { return true; }
void io_read(Value*) noexcept {}
void io_write(const Value*) noexcept {}
void io_close() noexcept {}
}
"""


def hosts(build, work):
    """A module for LinuxCNC, against headers of ours where its own are not there, and a loop of POSIX."""
    need("nm")
    prefix = install(build, work)
    project = work / "hosts"
    shutil.copytree(ROOT / "samples/nc110/lathe_16k20", project / "lathe_16k20")
    for name in ("coolant.sym", "coolant.plc", "MESSAGES"):
        shutil.copy(EXAMPLE / name, project)
    (project / "CMakeLists.txt").write_text(HOSTS)
    (project / "io.cpp").write_text(TERMINALS)
    binary = work / "binary"
    configure(project, binary, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DLINUXCNC_INCLUDE={ROOT}/tests/host/stub")
    run("cmake", "--build", binary)
    symbols = run("nm", "-DC", binary / "lathe.so")
    for name in ("rtapi_app_main", "rtapi_app_exit"):
        expect(f"the module exports {name}", re.search(rf" [TW] {name}$", symbols, re.MULTILINE))
    expect("it takes HAL from who loads it", re.search(r" U hal_init\b", symbols))
    expect("no run time of C++ is loaded with it", not re.search(r"std::|operator new|__cxa_(?!finalize|atexit)", symbols))
    for name in ("lathe.hal", "lathe.9"):
        expect(f"{name} is beside it", (binary / "lathe.plcxx" / name).is_file())
    expect("the loop has its main function", " T main" in run("nm", binary / "station_loop"))
    expect("nothing to do", "no work to do" in run("cmake", "--build", binary))
    refused = subprocess.run(["cmake", "-S", project, "-B", work / "without", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
                              "-DCMAKE_IGNORE_PATH=/usr/include/linuxcnc;/usr/local/include/linuxcnc"],
                             capture_output=True, text=True)
    expect("without LinuxCNC's headers it says what to install",
           refused.returncode != 0 and "linuxcnc-uspace-dev" in refused.stderr)


def cross_compiled(build, work):
    need("arm-none-eabi-g++", "arm-none-eabi-nm")
    prefix = install(build, work)
    binary = work / "binary"
    configure(EXAMPLE, binary, f"-Dplcxx_DIR={prefix}/lib/cmake/plcxx",
              f"-DCMAKE_TOOLCHAIN_FILE={EXAMPLE}/cortex-m4.cmake")
    run("cmake", "--build", binary)
    symbols = run("arm-none-eabi-nm", "-C", binary / "libcoolant.a")
    expect("a library for another processor holds the scan", "T coolant::period(" in symbols)

    hosted = work / "hosted"
    configure(EXAMPLE, hosted, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", hosted, "--target", "controller_library")
    library = hosted / "controller.plcxx" / "libcoolant.a"
    expect("one that plcxx build made and audited", "T coolant::period(" in run("arm-none-eabi-nm", "-C", library))
    expect("nothing to do", "no work to do" in run("cmake", "--build", hosted, "--target", "controller_library"))


def packed(build, work, kind, pattern):
    """The package that cpack makes."""
    run("cpack", "-G", kind, "--config", build / "CPackConfig.cmake", "-B", work / "packed")
    packages = list((work / "packed").glob(pattern))
    expect(f"one package of kind {kind}", len(packages) == 1)
    return packages[0]


def rpm_package(build, work):
    need("rpmbuild", "rpm", "objdump", "cpack")
    package = packed(build, work, "RPM", "*.rpm")
    files = run("rpm", "-qlp", package).splitlines()
    for name in ("bin/plcxx", "include/plcxx/bits.h", "lib/cmake/plcxx/plcxxConfig.cmake", "share/man/man1/plcxx.1",
                 "share/bash-completion/completions/plcxx", "share/doc/plcxx/README.md"):
        expect(f"it has /usr/{name}", any(file in (f"/usr/{name}", f"/usr/{name}.gz") for file in files))
    expect("it owns no folder of the system", not {"/usr", "/usr/bin", "/usr/share/man", "/usr/lib/cmake"} & set(files))
    required = run("rpm", "-qRp", package)
    recommended = run("rpm", "-q", "--recommends", "-p", package)
    for library in (r"libicuuc\.so\.\d+", r"libyaml-cpp\.so", r"libc\.so\.6"):
        expect(f"it requires {library}", re.search(library, required))
    expect("a compiler is recommended", "gcc-c++" in recommended)
    if (build / "lib" / "plcxx_z3.so").exists():
        expect("it requires libz3 and does not recommend it", "libz3" in required and "libz3" not in recommended)
    for module, library in (("hnc_parser", "libclang-cpp"), ("audit", "libLLVM"), ("http", "libcpp-httplib")):
        if (build / "lib" / f"plcxx_{module}.so").exists():
            expect(f"it recommends {library} and does not require it", library in recommended and library not in required)


def archive(build, work):
    package = packed(build, work, "TGZ", "*.tar.gz")
    place = work / "anywhere"
    place.mkdir()
    run("tar", "-xzf", package, "-C", place)
    folders = list(place.iterdir())
    expect("one folder", len(folders) == 1 and folders[0].name.startswith("plcxx-"))
    expect_shell_files(folders[0])
    tool = folders[0] / "bin" / "plcxx"
    expect("the tool runs from it", run(tool, "--version").startswith("plcxx "))
    if (build / "lib" / "plcxx_hnc_parser.so").exists():
        run(tool, "check", "--project", folders[0] / "share/doc/plcxx/samples/hnc/mill_xk7132/plcxx.yaml")
        expect("and finds its modules", True)


def debian_package(build, work):
    need("dpkg-deb", "dpkg-shlibdeps", "cpack")
    package = packed(build, work, "DEB", "*.deb")
    print(run("dpkg-deb", "--info", package))
    field = {name: run("dpkg-deb", "--field", package, name) for name in ("Depends", "Recommends")}
    expect("it depends on what the tool is linked with",
           all(re.search(pattern, field["Depends"]) for pattern in (r"\blibc6 ", r"\blibicu\d+ ", r"\blibyaml-cpp")))
    if (build / "lib" / "plcxx_z3.so").exists():
        expect("it depends on Z3", "libz3-" in field["Depends"] and "libz3-" not in field["Recommends"])
    for module, pattern in (("hnc_parser", r"\blibclang-cpp"), ("audit", r"\blibllvm"), ("http", r"\blibcpp-httplib")):
        if (build / "lib" / f"plcxx_{module}.so").exists():
            expect(f"it recommends what the module {module} needs, and does not depend on it",
                   re.search(pattern, field["Recommends"]) and not re.search(pattern, field["Depends"]))
    run("dpkg-deb", "-x", package, work / "root")
    expect_shell_files(work / "root" / "usr")
    tool = work / "root" / "usr" / "bin" / "plcxx"
    expect("the tool runs from it", run(tool, "--version").startswith("plcxx "))
    if (build / "lib" / "plcxx_hnc_parser.so").exists():
        (work / "empty.cld").write_text("#include \"plc.h\"\nvoid plc1(void) { Y[0] = X[0]; }\nvoid plc2(void) {}\nvoid init(void) {}\n")
        run(tool, "emit", work / "empty.cld", "--dialect", "hnc", "-o", work / "out", "--quiet")
        expect("its module is found", (work / "out" / "empty.cpp").exists())
        (work / "root" / "usr" / "lib" / "plcxx_hnc_parser.so").write_text("no library")
        refused = subprocess.run([tool, "check", work / "empty.cld", "--dialect", "hnc"], capture_output=True, text=True)
        expect("of a module that cannot be loaded the loader's cause is shown",
               refused.returncode == 1 and "file too short" in refused.stderr + refused.stdout)


def single_file(build, work):
    tool = build / "bin" / "plcxx"
    run(tool, "emit", EXAMPLE / "coolant.sym", EXAMPLE / "coolant.plc", "--set", f"messages={EXAMPLE}/MESSAGES",
        "--single-file", "-o", work, "--quiet")
    expect("one file of C++", sorted(file.name for file in work.iterdir()) ==
           ["coolant.hpp", "coolant.map.json", "coolant.report.json"])
    (work / "code.cpp").write_text("#define COOLANT_IMPLEMENTATION\n#include \"coolant.hpp\"\n")
    shutil.copy(EXAMPLE / "main.cpp", work)
    run(os.environ.get("CXX") or "c++", "-std=c++17", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror",
        "main.cpp", "code.cpp", "-o", "station", cwd=work)
    expect("it is a program with nothing else", "pump 2: 1" in run(work / "station") or "pump 1: 1" in run(work / "station"))


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def farm(build, work):
    need("distcc", "distccd")
    prefix = install(build, work)
    park = work / "park"
    park.mkdir()
    variants = 200
    lines = ["cmake_minimum_required(VERSION 3.25)", "project(park LANGUAGES CXX)", "find_package(plcxx REQUIRED)"]
    for number in range(variants):
        folder = park / f"machine{number}"
        folder.mkdir()
        shutil.copy(EXAMPLE / "coolant.sym", folder)
        text = (EXAMPLE / "coolant.plc").read_text().replace("T1I(50)", f"T1I({50 + number})")
        (folder / "coolant.plc").write_text(text)
        lines.append(f"plcxx_add_program(machine{number} SOURCES machine{number}/coolant.sym machine{number}/coolant.plc)")
    (park / "CMakeLists.txt").write_text("\n".join(lines) + "\n")

    daemons, ports, logs = [], [], []
    for number in range(2):
        port = free_port()
        log = work / f"distccd{number}.log"
        log.touch()
        log.chmod(0o666)  # the daemon gives up root
        daemons.append(subprocess.Popen(
            ["distccd", "--daemon", "--no-detach", "--allow", "127.0.0.1", "--listen", "127.0.0.1", "--port", str(port),
             "--jobs", "2", "--log-file", str(log), "--enable-tcp-insecure"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        ports.append(port)
        logs.append(log)
    try:
        for port in ports:
            for _ in range(100):
                with socket.socket() as probe:
                    if probe.connect_ex(("127.0.0.1", port)) == 0:
                        break
                time.sleep(0.1)
            else:
                sys.exit(f"FAILED: no distccd at port {port}")
        (work / "distcc").mkdir()
        env = dict(os.environ, DISTCC_HOSTS=" ".join(f"127.0.0.1:{port}/2" for port in ports), DISTCC_FALLBACK="0",
                   DISTCC_DIR=str(work / "distcc"))
        configure(park, work / "binary", f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_CXX_COMPILER_LAUNCHER=distcc", env=env)
        start = time.monotonic()
        run("cmake", "--build", work / "binary", env=env)
        print(f"{variants} programs in {time.monotonic() - start:.1f} s")
        shares = [log.read_text(errors="replace").count("COMPILE_OK") for log in logs]
        expect(f"both daemons compiled, together all of them: {shares}", min(shares) > 0 and sum(shares) == variants)
        expect("nothing to do", "no work to do" in run("cmake", "--build", work / "binary", env=env))
    finally:
        for daemon in daemons:
            daemon.terminate()
            daemon.wait()


def main():
    build, step = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    steps = {f.__name__: f for f in (installed, hosts, cross_compiled, debian_package, rpm_package, archive, farm, single_file)}
    with tempfile.TemporaryDirectory(prefix="plcxx-packaging-") as work:
        pathlib.Path(work).chmod(0o755)
        steps[step](build, pathlib.Path(work))


main()
