// `plcxx mcp`: the Model Context Protocol over standard input and output, for agents.
#pragma once

#include <string>

namespace plcxx::mcp {

struct ServerOptions {
  std::string plcxx;   // this program, for the commands that tools run
  std::string folder;  // that tools work in; absolute
  int most_seconds = 600;
};

/// Serves until the client closes its side; gives the exit code.
int Serve(const ServerOptions& options);

}  // namespace plcxx::mcp
