// What the build generates from explain/*.md (plcxx_embed in cmake/PlcxxTargets.cmake).
#pragma once

#include "transpiler/support/embedded_file.h"

namespace plcxx::diag {

using support::EmbeddedFile;

extern const EmbeddedFile kExplainPages[];  // sorted by name
extern const unsigned kExplainPagesCount;

}  // namespace plcxx::diag
