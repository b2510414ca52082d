// The main program of compiled engines: it owns State and Host, and obeys one-letter commands from a console, which is
// beside it as "console.h" (consoles/host.h says what that is). One executable may hold several programs, because the
// compiler's start, the headers and the linker cost more than most of them; a process serves the one whose number it
// reads first, from a State that is new, and another one after Q, because an emulator's start costs more than most
// scenarios:  <u32 program>
//
//   I                      init                     P <u32 now>   one period          F <u32 now>   fast part only
//   W <u32 at, mask, v>    host writes bits         K <u32 at, mask, v>  force bits   R <u32 at, mask>  release
//   T <u32 n, bytes>       operator text            E <u32 statement, on>             S  store retentive memory
//   L <u32 now>            time has passed          H <u32 Asking>  what host calls do from now on
//   Q                      the number of a program comes next
//
// K, R and E are commands of the debug flavour.
// I, P, F, L and T are answered: <u32 events> { <u32 function> <u32 n> <u64 argument>... } <bytes of State>.
// A host call that asks sends <u32 kHostQuestion> <u32 function> <u32 n> <u64 argument>... <bytes of State> instead,
// obeys W and S, and goes on after  A <u64 result, u32 has a second one, u64 second result>. Values are raw bits.
// With kTells it sends the same without State, and its answers stand behind the command already; D behind the last one
// has what was said delivered when a call finds no answer. Answers that no call has found are dropped.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "transpiler/emit/emittable.h"

namespace plcxx::engines {

/// Where the number of events stands otherwise.
inline constexpr uint32_t kHostQuestion = 0xFFFFFFFF;

/// What a host call does.
enum class Asking : uint32_t {
  kNobody,
  kWithState,
  kTells,
};

/// The C++ text of the main program for emitted programs, whose names differ.
std::string HarnessText(std::span<const emit::Emittable> programs);

}  // namespace plcxx::engines
