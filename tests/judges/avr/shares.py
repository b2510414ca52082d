"""What is done to a part of the random programs only: generated C++ on this machine and on emulated ones, and the proof of
plcxx verify. Whole batches are chosen, by their number, for their programs are compiled together."""
import collections
import re
import time

import children

NAMES = ("compiled", "emulated", "verified")
PLATFORMS = {"compiled": ("g++ -O0", "g++ -O2", "g++ -O3", "clang++-19 -O2"), "emulated": ("cortex-m", "riscv")}
VERDICT = re.compile(r"^  (\S+): (proved|not decided|different)", re.M)


class Shares:
    def __init__(self, plcxx, soak, every, deadline):
        self.plcxx, self.soak, self.every, self.deadline = plcxx, soak, every, deadline
        self.counts, self.verdicts = collections.Counter(), collections.Counter()

    def time_is_over(self):
        return self.deadline is not None and time.monotonic() > self.deadline

    def judge(self, batch, paths, report):
        """The scenarios that failed."""
        failed = []
        for number, share in enumerate(NAMES):
            if not self.soak or not self.every[share] or (batch + number) % self.every[share] or not paths:
                continue
            self.counts[share] += len(paths)
            for path, text in (self.verified(paths) if share == "verified" else self.run(share, paths)):
                report(f"FAILED {path} ({share})\n" + text)
                failed.append(str(path))
        return failed

    def run(self, share, paths):
        words = [word for platform in PLATFORMS[share] for word in ("--compiler", platform)]
        result = children.run([self.soak, "--judge", share, *words, *paths], 3600)
        found = [part.partition("\n") for part in result.stdout.split("FAILED ")[1:]]
        if result.returncode != 0 and not found:
            return [(paths[0], "the judge itself: " + result.stdout + result.stderr)]
        return [(path, text) for path, _, text in found]

    def verified(self, paths):
        for path in paths:
            result = children.run([self.plcxx, "verify", "--time", "4s", "--jobs", "1", path.with_suffix(".cld")], 3600)
            verdicts = [verdict for _, verdict in VERDICT.findall(result.stdout)]
            self.verdicts.update(verdicts)
            if result.returncode not in (0, 1) or not verdicts or "different" in verdicts:
                yield path, result.stdout + result.stderr

    def row(self, programs, values, failed, report):
        if not self.soak:
            return
        report(f"{'hnc':8} {programs:9} {0:7} {0:8} " + " ".join(f"{self.counts[name]:9}" for name in NAMES)
               + f" {values:16} {failed:14} {0:8} {0:12}")
        report(f"verify: {self.verdicts['proved']} functions proved, {self.verdicts['not decided']} not decided")
