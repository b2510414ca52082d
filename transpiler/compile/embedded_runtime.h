// The headers of runtime_support inside the tool, so that a moved binary can still compile what it generated.
#pragma once

#include "transpiler/support/embedded_file.h"

namespace plcxx::compile {

using support::EmbeddedFile;

extern const EmbeddedFile kRuntimeHeaders[];
extern const unsigned kRuntimeHeadersCount;
/// Of runtime_support/plcxx_host.
extern const EmbeddedFile kHostHeaders[];
extern const unsigned kHostHeadersCount;

}  // namespace plcxx::compile
