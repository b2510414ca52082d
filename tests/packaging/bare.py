#!/usr/bin/env python3
"""Two bare machines: in one plcxx is built and packed as the README says, in the other the .deb is installed and used.

bare.py WORK [--deb FILE] [--bare FOLDER]    exit code 77: not root, or no debootstrap

WORK is emptied. --deb: only the second machine, with this package. --bare: a folder that debootstrap has made, instead of
making one. A machine is a Debian 12 of debootstrap's smallest variant in a folder, entered with chroot.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROJECT = "/srv/project"


def expect(what, found):
    print(("ok: " if found else "FAILED: ") + what, flush=True)
    if not found:
        sys.exit(1)


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"FAILED: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


class Machine:
    """A copy of the bare one."""

    def __init__(self, folder, bare):
        self.folder = folder
        self.mounted = []
        run("cp", "--archive", bare, folder)
        shutil.copy("/etc/resolv.conf", folder / "etc/resolv.conf")
        sources = folder / "etc/apt/sources.list"
        mirror = sources.read_text().split()[1]  # the one that debootstrap took
        sources.write_text(f"deb {mirror} bookworm main\ndeb {mirror} bookworm-updates main\n"
                           f"deb {mirror}-security bookworm-security main\n")
        for name in ("proc", "dev"):
            self.mount(pathlib.Path("/") / name, name)
        self.run("apt-get", "update")

    def mount(self, source, name, *options):
        place = self.folder / name
        place.mkdir(parents=True, exist_ok=True)
        run("mount", "--bind", source, place)
        self.mounted.append(place)
        if options:
            run("mount", "-o", ",".join(("remount", "bind", *options)), place)

    def close(self):
        while self.mounted:
            run("umount", "--lazy", self.mounted.pop())

    def call(self, *command, cwd="/srv", **environment):
        """The finished process."""
        env = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/srv", "LC_ALL": "C.UTF-8",
               "DEBIAN_FRONTEND": "noninteractive", **environment}
        script = 'cd "$1" && shift && exec "$@"'
        words = ["chroot", str(self.folder), "sh", "-c", script, "sh", str(cwd), *map(str, command)]
        return subprocess.run(words, env=env, capture_output=True, text=True)

    def run(self, *command, **options):
        done = self.call(*command, **options)
        if done.returncode != 0:
            sys.exit(f"FAILED on the bare machine: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def install(self, *packages):
        return self.run("apt-get", "install", "-y", "--no-install-recommends", *packages)


def build_packages(work, bare):
    """The .deb that a bare machine makes with what README and docs/install.md name."""
    machine = Machine(work / "builds", bare)
    try:
        source = str(ROOT).lstrip("/")
        (ROOT / "build").mkdir(exist_ok=True)  # what the other one is mounted over
        machine.mount(ROOT, source, "ro")
        (work / "build").mkdir()
        machine.mount(work / "build", source + "/build")
        cache = os.environ.get("CCACHE_DIR") or shutil.which("ccache") and run("ccache", "--get-config", "cache_dir").strip()
        options = {}
        if cache and pathlib.Path(cache).is_dir():
            machine.mount(pathlib.Path(cache), "ccache")
            options["CCACHE_DIR"] = "/ccache"
        machine.run("dev/build", cwd=ROOT, **options)
        machine.run("dev/install", "package", cwd=ROOT)
        machine.run("cpack", cwd=ROOT / "build")
    finally:
        machine.close()
    packages = list((work / "build").glob("*.deb"))
    expect("a bare machine builds plcxx and one .deb", len(packages) == 1)
    expect("and an archive", len(list((work / "build").glob("*.tar.gz"))) == 1)
    return packages[0]


def use_tool(machine):
    """What runs with the package's Depends alone."""
    commands = re.findall(r"^  ([a-z]+)  +[A-Z]", machine.run("plcxx", "--help"), re.M)
    expect(f"it has its commands: {', '.join(commands)}", {"emit", "check", "test", "build", "diff", "lsp"} <= set(commands))
    for command in commands:
        expect(f"plcxx {command} --help", f"plcxx {command}" in machine.run("plcxx", command, "--help"))
    samples = "/usr/share/doc/plcxx/samples"
    for sample in ("nc110/lathe_16k20", "prostep/mill_fnd32", "host50/ck6150", "technol/mcv_750"):
        machine.run("plcxx", "emit", "--quiet", "--project", f"{samples}/{sample}/plcxx.yaml", "-o", "out")
    expect("four languages are transpiled", True)
    # The loader's words: which library is missing, for whoever looks for its package.
    refused = machine.call("plcxx", "check", "--project", f"{samples}/hnc/mill_xk7132/plcxx.yaml")
    said = refused.stdout + refused.stderr
    expect("of hnc it says which library is missing", refused.returncode == 1 and "libclang-cpp.so" in said)
    table = (ROOT / "docs" / "troubleshooting.md").read_text()
    named = re.search(r"(lib[a-z-]+)\.so", said[said.find("cannot be loaded: ") + 18:]).group(1)
    expect(f"and docs/troubleshooting.md has its package: {named}", f"`{named}" in table)
    return samples


def install_package(work, bare, package):
    machine = Machine(work / "uses", bare)
    try:
        shutil.copy(package, machine.folder / "srv" / "plcxx.deb")
        advised = machine.run("apt-get", "install", "--simulate", "./plcxx.deb")
        for name in ("libclang-cpp19", "libllvm19", "clang-19", "g++"):
            expect(f"apt would install the recommended {name}", re.search(rf"^Inst {re.escape(name)} ", advised, re.M))
        machine.install("./plcxx.deb")
        samples = use_tool(machine)
        for page in ("man/man1/plcxx.1", "man/man1/plcxx-check.1", "bash-completion/completions/plcxx",
                     "zsh/site-functions/_plcxx", "fish/vendor_completions.d/plcxx.fish"):
            expect(f"share/{page}", (machine.folder / "usr/share" / page).is_file())

        machine.run("cp", "-r", f"{samples}/cmake_project", PROJECT)
        (machine.folder / "srv" / "p.prop").write_text("never !PUMP1 and !PUMP2\n")
        expect("prove", "1 proved" in machine.run("plcxx", "prove", "--property", "../p.prop", cwd=PROJECT))
        machine.install("g++")
        machine.run("plcxx", "emit", "--quiet", cwd=PROJECT)
        expect("emit", (machine.folder / "srv/project/generated/coolant.cpp").is_file())
        expect("test", "1 scenario passed" in machine.run("plcxx", "test", cwd=PROJECT))
        machine.run("plcxx", "build", "--target", "host", "--no-audit", "-o", "built", cwd=PROJECT)
        expect("build", (machine.folder / "srv/project/built/libcoolant.a").is_file())
        machine.run("c++", "-std=c++17", "-I", "generated", "generated/coolant.cpp", "main.cpp", "-o", "station", cwd=PROJECT)
        expect("the C++ runs with the installed headers", "lamp came on" in machine.run("./station", cwd=PROJECT))

        machine.install("libclang-cpp19", "libllvm19")
        machine.run("plcxx", "check", "--project", f"{samples}/hnc/mill_xk7132/plcxx.yaml")
        expect("hnc with its library", True)
        machine.run("apt-get", "purge", "-y", "plcxx")
        left = list((machine.folder / "usr").rglob("*plcxx*"))
        expect(f"nothing is left of it: {left[:3]}", not left)
    finally:
        machine.close()


def remove(work):
    """Nothing that is mounted in it: a folder of this machine would be emptied."""
    mounted = [line.split()[1] for line in pathlib.Path("/proc/self/mounts").read_text().splitlines()]
    if any(pathlib.Path(place).is_relative_to(work) for place in mounted):
        sys.exit(f"FAILED: something is mounted in {work}")
    shutil.rmtree(work, ignore_errors=True)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("work", type=pathlib.Path)
    arguments.add_argument("--deb", type=pathlib.Path)
    arguments.add_argument("--bare", type=pathlib.Path)
    given = arguments.parse_args()
    if os.geteuid() != 0 or shutil.which("debootstrap") is None:
        print("skipped: needs root and debootstrap")
        sys.exit(77)
    if "PLCXX_BARE_MOUNTS" not in os.environ:  # mounts of its own, which end with it, however it ends
        os.environ["PLCXX_BARE_MOUNTS"] = "own"
        os.execvp("unshare", ["unshare", "--mount", "--propagation", "private", sys.executable, *sys.argv])
    work = given.work.resolve()
    remove(work)
    work.mkdir(parents=True)
    bare = given.bare or work / "bare"
    if not given.bare:
        run("debootstrap", "--variant=minbase", "--include=ca-certificates", "bookworm", bare)
    package = given.deb.resolve() if given.deb else build_packages(work, bare)
    install_package(work, bare, package)
    remove(work)


main()
