// Who reads and who writes a signal: the accesses of the program that touch its bits.
#pragma once

#include <vector>

#include "transpiler/lsp/names.h"

namespace plcxx::lsp {

struct Uses {
  std::vector<source::Range> reads, writes;  // each place once, in the order of the program
};

Uses UsesOf(const ir::Program& program, const Bits& bits);

/// What is known of a signal from the program: null where nothing is.
const ir::Documentation* DocumentationOf(const Names& names, const Target& target, std::string_view spelling);

}  // namespace plcxx::lsp
