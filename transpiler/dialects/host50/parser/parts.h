// The parts that the sources consist of (specification 3.2), as lines; what stands in them is read afterwards.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "transpiler/dialects/host50/source/lexer.h"
#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::host50 {

/// Of a network: the lines [first, last) of a file.
struct Body {
  NetworkId network;
  uint32_t file = 0;
  uint32_t first = 0, last = 0;
};

/// The rows of TITLE, SYMBOLS, ALARMS or MCODES: the lines [first, last) of a file.
struct TablePart {
  PartKind part{};
  uint32_t file = 0;
  uint32_t first = 0, last = 0;
};

struct DirectiveLine {
  uint32_t file = 0, line = 0;
};

struct Parts {
  std::vector<Body> bodies;
  std::vector<TablePart> tables;
  std::vector<DirectiveLine> directives;
  std::map<uint32_t, SectionId> subroutines;  // by number
  std::map<std::pair<SectionId, uint32_t>, NetworkId> labels;
};

}  // namespace plcxx::host50
