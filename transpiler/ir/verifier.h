// Checks that a program keeps the rules of the IR. A finding is a fault of plcxx, never of the source program.
//
// The rules: values are computed before their use, in the same region or one around it, and used before the next
// statement's marker of that region; operands, loads, stores, steps and calls have the declared types; places lie
// inside their spaces; each region has one owner; an Exit names a block or loop around it; loops have a bound; calls
// make no cycle; jumps go forward within their region, and only before structuring; every statement of the source has
// exactly one marker; routines have parameters, results and callers as their kinds allow.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

enum class Stage : uint8_t {
  kLowered,    // forward jumps are allowed
  kStructured  // regions only
};

/// One line per broken rule, in program order; empty when the program keeps them all. Linear in the program's size.
std::vector<std::string> Verify(const Program& program, Stage stage);

}  // namespace plcxx::ir
