// What the generators of random programs make: rows of the grammar, instructions with their operands, options with
// their values, steps of scenarios.
//
// A construct that no generator makes is one that no random program tests. The rows come from the grammars
// (grammars/<dialect>.ebnf: every word and sign), from the machine's tables (made_forms.h), from the dialect's own
// table of options, and from what a scenario can do; how often each was made is counted in the programs' texts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/reference/reference_dialects.h"

namespace plcxx::reference {

struct MadeRow {
  std::string group;  // "word", "operand", "option", "step", "form"
  std::string name;
  uint64_t count = 0;
};

/// Over the programs of the seeds 0 .. programs-1, one in 20 of them large.
std::vector<MadeRow> CountMade(const ReferenceDialect& dialect, uint32_t programs);

/// Rows of tests/reference/never_made.txt: "dialect group name: why no program needs it".
struct NeverMade {
  std::string dialect, group, name, reason;
};
std::vector<NeverMade> ReadNeverMade();

}  // namespace plcxx::reference
