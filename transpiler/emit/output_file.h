// The generated files, and what of their text other phases have to know.
//
// What `plcxx build` and `plcxx verify` find again in compiled code, they find by the lines and names recorded here,
// never by reading the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::emit {

/// A loop as it stands in a generated file: what `plcxx build` measures its repetitions by.
struct PrintedLoop {
  uint32_t line = 0;               // of its head, from 1
  std::optional<uint64_t> rounds;  // the most that it makes; none: only a budget that others share bounds it
  ir::PlaceId budget = {};         // that budget
};

/// Whose the lines of a generated file are, from `line` (from 1) up to the next one's.
struct LineOwner {
  uint32_t line = 0;
  ir::StatementId statement;  // none: no statement's
};

/// Names of the locals of a file, by InstId.
using LocalNames = std::unordered_map<uint32_t, std::string>;

struct OutputFile {
  std::string name;  // without directory
  std::string text;
  // Of a .cpp file, in the order of the text:
  std::vector<PrintedLoop> loops = {};
  std::vector<LineOwner> owners = {};
  LocalNames locals = {};
};

}  // namespace plcxx::emit
