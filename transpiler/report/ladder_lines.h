// Ladder rungs as text, for people without a picture and for programs that read:
//
//   |--[ I0A3 ]--+--[/I0A7 ]--+--( U4A8 )
//   |            +--[ U4A8 ]--+
//
// In: a program's input. Out: lines in UTF-8, one routine below the other; what the pictures show is there (ladder.h),
// but addresses below names. Not its job: coordinates (ladder_drawing.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "transpiler/report/program_input.h"

namespace plcxx::report {

/// Whose rungs are wanted: what they name so, by name or by address, and what reads or writes the place, which a user
/// may spell otherwise than a picture does.
struct WantedRungs {
  std::string_view word;
  std::optional<ir::Place> place;  // none: no location is written so
};

/// Without `wanted` all of them.
std::string LadderLines(const ProgramInput& input, const std::optional<WantedRungs>& wanted = std::nullopt);

}  // namespace plcxx::report
