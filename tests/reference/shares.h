// What costs too much for every random program, and is done to one in N: generated C++ on this machine and on emulated
// ones, and the proof of `plcxx verify`.
//
// Programs are compiled and run sixteen at a time. The work is done by this executable itself (`plcxx_soak --judge`)
// and by plcxx, in processes of their own: what they crash on is a disagreement, not the end of the soak.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reference/random_program.h"

namespace plcxx::reference {

enum class Share : uint8_t { kCompiled, kEmulated, kVerified };
constexpr std::array<std::string_view, 3> kShareNames = {"compiled", "emulated", "verified"};

/// One in how many programs; 0: none.
using ShareSizes = std::array<uint64_t, 3>;

struct ShareCounts {
  uint64_t programs = 0;
  // of kVerified: functions
  uint64_t proved = 0, not_decided = 0;
};

struct Disagreement {
  size_t program = 0;  // of those that were judged
  std::string text;
};

/// A program with its folder, which has its files.
struct JudgedProgram {
  std::string folder;
  std::string dialect;
  RandomProgram program;
};

/// How the judges are called.
struct Judges {
  std::string soak;   // this executable
  std::string plcxx;  // for kVerified
  std::vector<std::string> compilers = {"g++ -O0", "g++ -O2", "g++ -O3", "clang++-19 -O2"};
  std::vector<std::string> machines = {"cortex-m", "riscv"};
  /// Asked while they run: true ends them at once, and what Judge gives then says nothing.
  std::function<bool()> stops = [] { return false; };
};

std::vector<Disagreement> Judge(Share share, const std::vector<JudgedProgram>& programs, const Judges& judges,
                                ShareCounts& counts);

/// `--judge`: runs scenarios in the simulator and on the platforms; one line "FAILED path" for each that fails, what it
/// says behind it. The exit code of the process.
int RunJudge(Share share, const std::vector<std::string>& platforms, const std::vector<std::string>& scenarios);

}  // namespace plcxx::reference
