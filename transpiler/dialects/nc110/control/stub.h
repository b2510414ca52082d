// A simulated control for dialect nc110: what section 8.2 of the specification says that the NC does.
//
// It looks at the image right before a period and answers there; every accepted motion ends after `stub-ms`. What the
// user sets or forces wins: a signal is written when the stub's own state changes, never merely to keep it. There is
// no part program, so a code that appears in W3K0 (M), W8K0..W8K2 (S), W4K0..W4K1 (T) or W1K0..W1K3 (index axis) is
// taken as programmed: the stub gives its strobe and ends strobe and pulse after two slow cycles.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::nc110 {

/// None unless option `nc-stub` is on.
std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options);

}  // namespace plcxx::nc110
