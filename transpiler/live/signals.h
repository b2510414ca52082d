// What the page lists: the signals of a program with their names and comments, and how each is read.
//
// In: the report's cross reference. Out: a table that does not change, and the values of a moment. Not its job: values
// as text (the page writes them in the base that its reader chose).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/ir/program.h"
#include "transpiler/report/cross_reference.h"

namespace plcxx::live {

enum class SignalGroup : uint8_t { kInput, kOutput, kInternal, kRetentive, kInstance };

struct LiveSignal {
  std::string name, address, words;
  std::string type;  // "bit", "i16", "on_delay_timer"
  SignalGroup group{};
  std::optional<dialects::Location> location;  // none: an instance, whose value is a text
  ir::StateId state;                           // of an instance
  bool can_be_named = false;                   // commands find it by its name
};

/// In the order of the cross reference, `index` by its numbers; local names are not among them.
struct SignalTable {
  std::vector<LiveSignal> signals;
  std::vector<uint32_t> of_reference;  // by number of the cross reference; kNoSignal: not listed
};

SignalTable MakeSignals(const compilation::Compilation& compilation, const report::CrossReference& uses);

}  // namespace plcxx::live
