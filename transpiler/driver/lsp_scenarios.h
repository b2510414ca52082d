// What the language server says of scenarios: which of them run a program, and why a signal is what it is at their end.
#pragma once

#include "transpiler/lsp/scenario_answers.h"

namespace plcxx::driver {

lsp::ScenarioAnswers AnswersOfScenarios();

}  // namespace plcxx::driver
