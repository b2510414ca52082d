// A program as `plcxx prove` sees it: the slow part in one piece, its locations, its times, its inputs by name.
//
// One period of the proofs is one slow pass: of a program whose slow part is cut into slices as long as all of them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/prove/machine/version.h"
#include "transpiler/prove/properties/property.h"

namespace plcxx::scenarios {

/// An input as a scenario sets it.
struct InputWord {
  std::string name;
  std::vector<execute::CellId> cells;  // from the least significant bit
};

struct ProveMachine {
  compilation::Compilation compilation;  // its program: the slow part in one piece, optimized
  uint32_t slices = 1;                   // of the program as it runs
  prove::machine::Version version;
  prove::properties::PropertyTiming timing;
  std::vector<InputWord> named;  // by properties: the program itself need not have a place there
};

/// Compiles; when that fails the diagnostics say why, and the rest is of no use. The machine must not be moved after.
void MakeProveMachine(const compilation::CompilationRequest& request, ProveMachine& machine);

/// Cells and words of a program as its scenarios write them. Both outlive what it gives.
prove::properties::PropertyContext PropertyContextOf(const dialects::Dialect& dialect, const ir::Program& program,
                                                     const execute::Cells& cells,
                                                     const prove::properties::PropertyTiming& timing);

/// Notes the locations that a property names.
void NameLocationsOf(const prove::properties::Property& property, ProveMachine& machine);

/// What time the parts of a program take, in periods: measured by running it.
prove::properties::PropertyTiming TimingOf(const ir::Program& program);

/// For each of `cells` the name that a scenario can set it by; none for a cell that has none.
std::vector<InputWord> WordsOf(const ProveMachine& machine, const std::vector<execute::CellId>& cells);

}  // namespace plcxx::scenarios
