// The audit of what runs in real time of a host (`plcxx build --host`): one period, from reading the pins to writing
// them.
#pragma once

#include <string_view>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/program_code.h"
#include "transpiler/emit/emittable.h"

namespace plcxx::measure {

/// Reports what one period of a host must not do: all that is reached from the functions in whose text `entry` is.
/// `own`: functions that the builder of the machine writes ("plcxx::host::io_read").
void AuditPeriod(const compile::ProgramCode& code, std::string_view entry, const std::vector<std::string_view>& own,
                 const emit::Emittable& emittable, compilation::Compilation& compilation);

}  // namespace plcxx::measure
