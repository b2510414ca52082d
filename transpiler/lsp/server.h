// `plcxx lsp`: the Language Server Protocol 3.17 over standard input and output.
#pragma once

namespace plcxx::lsp {

/// Serves until the client says exit or closes its side; gives the exit code of the protocol: 0 after shutdown, else 1.
int Serve();

}  // namespace plcxx::lsp
