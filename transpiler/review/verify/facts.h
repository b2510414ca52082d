// The facts that a program's code rests on (ir/facts.h), for plcxx verify: proved, and what is not proved shown.
//
// In: what was asked to be compiled; it is compiled once more, in its checked flavour. Out: of each fact whether it
// holds for every state; a state that says otherwise has been executed in the simulator.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/prove/verify/facts/facts.h"

namespace plcxx::review::verify {

struct FactFinding {
  prove::verify::facts::FactResult result{};
  std::string kind;     // "INDEX"
  std::string place;    // "main.cld:7:9: a[i] = 0;"
  std::string reason;   // of kNotDecided
  uint64_t value = 0;   // of kViolated
  std::string routine;  // likewise: that comes to it
  std::string state;    // likewise: "D.4=12, n=3"
};

struct FactsReport {
  std::string refusal;  // why nothing was looked at; empty: it was
  std::vector<FactFinding> findings;

  size_t CountOf(prove::verify::facts::FactResult result) const;
  bool all_proved() const;
  /// Indented lines.
  std::string Text() const;
};

/// The same sources with a check at each fact: what VerifyFactsOf reads.
compilation::Compilation CompileChecked(compilation::CompilationRequest request);
/// `routines`: by name; empty: all.
FactsReport VerifyFactsOf(const compilation::Compilation& checked, const std::vector<std::string>& routines,
                          const prove::verify::facts::FactLimits& limits);

}  // namespace plcxx::review::verify
