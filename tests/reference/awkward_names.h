// Names that a program may give its signals, cells and routines, and that mean something in C++ or in generated code.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "tests/reference/random_program.h"

namespace plcxx::reference {

/// Letters and digits only, at most ten, and no two the same but for case: a name in each of the languages.
inline constexpr std::array kAwkwardNames = {
    "int",     "class",  "m",      "host",  "State",  "init",   "slow",     "fast",     "plcxx",     "true",   "auto",
    "union",   "errno",  "NULL",   "main",  "new",    "delete", "bit",      "t1",       "t2",        "std",    "signed",
    "mutable", "static", "Forced", "left",  "entry",  "stepx",  "again",    "value",    "EOF",       "assert", "copy",
    "mm",      "period", "Clear",  "Pins",  "resume", "now",    "masks",    "layout",   "retentive", "min",    "byte1",
    "double",  "void",   "this",   "const", "kind",   "rounds", "template", "explicit", "goto"};

/// Each of them at most once in a program; empty when there is none left.
class AwkwardNames {
 public:
  std::string Next(Random& random) {
    if (used_ == 0) first_ = random.Below(kAwkwardNames.size());
    if (used_ == kAwkwardNames.size()) return "";
    return kAwkwardNames[(first_ + used_++) % kAwkwardNames.size()];
  }

 private:
  size_t first_ = 0, used_ = 0;
};

}  // namespace plcxx::reference
