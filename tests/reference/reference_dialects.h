// The dialects that have a second reading: one row each.
#pragma once

#include <memory>
#include <ostream>
#include <span>
#include <string_view>

#include "tests/reference/random_program.h"
#include "tests/reference/reference.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::reference {

struct ReferenceDialect {
  std::string_view name;
  /// Parses the request's sources again; they are without errors.
  std::unique_ptr<Reference> (*make)(dialects::Request& request, HostCalls host);
  /// Programs without errors, with a scenario that drives them.
  RandomProgram (*generate)(Random& random, ProgramSize size, Spelling spelling);
  /// Where one text cuts statements otherwise than the other (calls of macros), equal traces are enough.
  bool spelling_cuts_statements = false;
  /// Golden scenarios and samples that the reference passes over. May only become smaller.
  uint32_t unsupported_scenarios = 0;
};

/// For messages of tests.
inline void PrintTo(const ReferenceDialect& dialect, std::ostream* out) { *out << dialect.name; }

std::span<const ReferenceDialect> ReferenceDialects();
/// None: there is none.
const ReferenceDialect* FindReference(std::string_view dialect);

}  // namespace plcxx::reference
