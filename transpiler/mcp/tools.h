// The tools of the MCP server: one row each, with its schema and the function that it is.
//
// A tool takes a JSON object and gives one; each runs commands of plcxx in the server's folder. Files are named
// relative to that folder, and none outside of it is read as a source or written.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "transpiler/mcp/child_run.h"
#include "transpiler/rpc/json_rpc.h"

namespace plcxx::mcp {

using rpc::Json;

/// What every tool knows: where it works and how far.
struct Workplace {
  std::string plcxx;   // the program that is run
  std::string folder;  // absolute
  int most_seconds = 600;
  size_t most_bytes = size_t{1} << 20;
};

struct Tool {
  std::string_view name;
  std::string_view title;
  std::string_view description;
  Json (*schema)();  // of its parameters
  /// Throws rpc::Error where the parameters are wrong.
  Json (*run)(const Workplace& workplace, const Json& arguments);
  bool writes = false;  // files in the folder, where the parameters say so
};

std::span<const Tool> Tools();

}  // namespace plcxx::mcp
