// A program that is run to its end within limits of time and output.
//
// A tool of the MCP server is a command of plcxx in a process of its own: whatever happens to it, the server answers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plcxx::mcp {

struct Limits {
  int seconds = 60;
  size_t output_bytes = size_t{1} << 20;  // of standard output, and of standard error
};

struct ChildResult {
  int exit_code = -1;  // -1: it could not be started, or was killed
  std::string output, errors;
  bool timed_out = false;
  bool cut_off = false;  // there was more output than the limit
};

/// It and what it starts are killed when its time is over. Standard input is empty.
ChildResult RunChild(const std::vector<std::string>& arguments, const std::string& directory, const Limits& limits);

}  // namespace plcxx::mcp
