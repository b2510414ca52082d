// Programs as a client describes them in its initialization options:
//
//   {"programs": [{"sources": ["lathe.sym", "fast.plc"], "dialect": "nc110", "base": "/machines/lathe",
//                  "options": {"clo": "10,2"}, "encoding": "cp866", "include": [], "systemInclude": [],
//                  "define": ["A=1"], "warnings": ["no-W303"]}]}
#pragma once

#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/rpc/json_rpc.h"

namespace plcxx::lsp {

/// Throws rpc::Error where they are wrong. Without programs: none.
std::vector<compilation::CompilationRequest> ReadPrograms(const rpc::Json& options);

}  // namespace plcxx::lsp
