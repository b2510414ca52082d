// `plcxx lsp`: the Language Server Protocol 3.17 over standard input and output.
#pragma once

#include "transpiler/lsp/scenario_answers.h"

namespace plcxx::lsp {

/// Serves until the client says exit or closes its side; gives the exit code of the protocol: 0 after shutdown, else 1.
int Serve(ScenarioAnswers answers);

}  // namespace plcxx::lsp
