// The text form of a program: what `plcxx print ir` shows, and what unit tests build programs from (reader.h).
//
// Deterministic, one line per declaration and instruction, and local: a value is numbered from its statement on, a
// statement is named by its own text's hash, a block by its depth, so that a changed statement changes its own lines
// only. Not in the text: source ranges and Program::documentation (both belong to the source, not to the logic).
//
//   program turret nc110
//   space A 32 volatile little host_visible "package A"
//   zone A 0 4 input
//   zone A bits 38 40 input                  of bits, where it is not of whole bytes
//   space bits 90 volatile little arrays     each zone is an array, the place of which depends on the sizes
//   space D_kept 64 retentive little part_of D 12   of the control's memory D from byte 12 on
//   constant A 16 32                         a table that the sources declare constant
//   initial A 5 0xf
//   state T5 on_delay_timer
//   place U4A8 bit A[4].0 address %U4A8      memory; bit 0 of byte 4
//   place T5U bit field T5 done              a field of an instance
//   place ROW i8 A[8] stride 2 low 8 high 28 indexed
//   host fault (kind : i8 = (LOW, HIGH), index : i32) -> i16 writes_state "what it is"
//   statement s1f U4A8 opens
//   routine slow slow (slice : i8 = slice) -> i8 result sliced 4 {
//     stmt s1f ; U4A8
//     %0 = load U4A8
//     %1 = const i8 0x33
//     if %0 {
//       store ROW[%2] %1
//     } else {
//       exit @1 if %3
//     }
//   }
#pragma once

#include <string>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// The whole program. Never fails, also not on a program that the verifier refuses (but its regions must be a tree).
std::string Print(const Program& program);

}  // namespace plcxx::ir
