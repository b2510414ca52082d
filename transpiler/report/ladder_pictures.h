// Ladder pictures that stand alone: one for each routine, or all below each other.
#pragma once

#include <string>
#include <vector>

#include "transpiler/report/program_input.h"

namespace plcxx::report {

struct Picture {
  std::string name;  // of the routine, as the source has it
  std::string svg;   // the text of an .svg file
};

/// The routines that have rungs, in the order of the program. Above each rung stand the source's comments and the
/// statement's first line.
std::vector<Picture> LadderPictures(const ProgramInput& input);
/// All of them in one picture.
std::string LadderPicture(const ProgramInput& input);

}  // namespace plcxx::report
