// Ladder rungs as text, for people without a picture and for programs that read:
//
//   |--[ I0A3 ]--+--[/I0A7 ]--+--( U4A8 )
//   |            +--[ U4A8 ]--+
//
// In: a program's input. Out: lines in UTF-8, one routine below the other; what the pictures show is there (ladder.h),
// but addresses below names. Not its job: coordinates (ladder_drawing.h).
#pragma once

#include <string>
#include <string_view>

#include "transpiler/report/program_input.h"

namespace plcxx::report {

/// `signal` not empty: only the statements whose rungs name it, by name or by address.
std::string LadderLines(const ProgramInput& input, std::string_view signal = {});

}  // namespace plcxx::report
