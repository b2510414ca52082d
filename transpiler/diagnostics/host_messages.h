// The messages of hosts (plcxx emit --host), which only what raises them includes.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::diag {

#define PLCXX_DIAG(Key, Code, Sev, Params, What, Remedy) \
  inline constexpr Message<PLCXX_DIAG_UNWRAP Params> Key{{#Key, Code, Severity::Sev, What, Remedy}};
#include "transpiler/diagnostics/catalogue_host.def"
#undef PLCXX_DIAG

}  // namespace plcxx::diag
