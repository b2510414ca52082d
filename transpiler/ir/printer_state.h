// What the printer's files share: the names of everything, and the text so far.
#pragma once

#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

struct Printer {
  const Program& program;
  std::string out;
  std::vector<std::string> spaces, places, states, host_functions, routines, statements;  // by index, ready to print

  explicit Printer(const Program& printed);

  std::string PlaceName(PlaceId id) const { return id.valid() ? places[id.index] : "none"; }

  void PrintDeclarations();  // printer_declarations.cc
  void PrintSchedule();      // printer_declarations.cc
  void PrintRoutines();      // printer.cc
};

}  // namespace plcxx::ir
