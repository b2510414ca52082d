// The main program of a compiled engine: it owns State and Host, and obeys one-letter commands on standard input.
//
//   I                      init                     P <u32 now>   one period          F <u32 now>   fast part only
//   W <u32 at, mask, v>    host writes bits         K <u32 at, mask, v>  force bits   R <u32 at, mask>  release
//   T <u32 n, bytes>       operator text            E <u32 statement, on>             S  store retentive memory
//
// I, P, F and T are answered: <u32 events> { <u32 function> <u32 n> <u64 argument>... } <bytes of State>.
#pragma once

#include <string>

#include "transpiler/emit/emittable.h"

namespace plcxx::driver {

/// The C++ text of the main program for one emitted program.
std::string HarnessText(const emit::Emittable& emittable);

}  // namespace plcxx::driver
