// What compiled code must not do (design, section 2, "bounded"): the rules of `plcxx build`'s audit.
//
// In: the objects as facts, and what the program may need. Out: findings, which the driver turns into diagnostics.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compile/program_code.h"

namespace plcxx::compile {

enum class AuditRule : uint8_t {
  kUnreadable,  // a function that could not be decoded: nothing is known of it
  kHeap,
  kException,
  kStaticConstructor,
  kRecursion,
  kIndirectCall,
  kFloat,
  kUndefined
};

struct AuditFinding {
  AuditRule rule;
  std::string function;  // as the source calls it, or a section's name
  std::string detail;    // the symbol, or the circle of calls
};

struct AuditExpectations {
  std::set<std::string> host_functions;  // "mill::fault"
  bool has_floats = false;
};

/// Sorted as the objects and their functions are; each finding once.
std::vector<AuditFinding> Audit(const ProgramCode& code, const AuditExpectations& expectations);

/// Only of what the functions reach by calls in whose text `entry` is ("::Run(void*, long)"): of a host's code, most of
/// which may wait. None: there is no such function.
std::optional<std::vector<AuditFinding>> AuditFrom(const ProgramCode& code, std::string_view entry,
                                                   const AuditExpectations& expectations);

enum class RoutineUse : uint8_t { kUnknown, kMemory, kInteger, kFloat, kHeap, kException };
/// What a symbol that no object defines is for.
RoutineUse UseOfSymbol(std::string_view name);

}  // namespace plcxx::compile
