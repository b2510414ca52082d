// Reads the text form of a program; see printer.h for the form.
//
// Print(Read(Print(p))) == Print(p). Unit tests write short texts: `program` and `statement` lines may be missing, a
// `stmt s1f` declares its statement, `;` begins a comment, indentation and blank lines do not matter. Declarations of
// spaces, states, places and host functions stand before their uses; routines may call routines further down. Names of
// values are free (`%lamp`), but only numbers come back.
//
// Not its job: whether the program makes sense (verifier.h). What it gives may be refused there, so that a test of the
// verifier is a text, too.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

struct ReadError {
  uint32_t line = 0;  // 1-based
  std::string message;
};

std::variant<Program, ReadError> Read(std::string_view text);

/// For tests: the program of a text that is known to be right; anything else ends the process with its line.
Program ReadOrDie(std::string_view text);

}  // namespace plcxx::ir
