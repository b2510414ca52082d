// What the server asks of those who run scenarios: it knows programs, and not how they run.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace plcxx::lsp {

struct ScenarioAnswers {
  /// Of these files, and of the files in these folders, the scenarios that run one of these sources (FileIdentity).
  using OfProgram = std::function<std::vector<std::string>(const std::vector<std::string>& paths,
                                                           const std::vector<std::string>& sources)>;
  /// Why a signal is what it is at the end of a scenario, in lines; where that cannot be told: why not.
  using Why = std::function<std::string(const std::string& scenario, const std::string& signal)>;

  OfProgram of_program;
  Why why;
};

}  // namespace plcxx::lsp
