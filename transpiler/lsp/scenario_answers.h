// What the server asks of those who run scenarios and plants: it knows programs, and not how they run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/yaml/place.h"

namespace plcxx::lsp {

/// The text of a file beside a program, saved or not.
struct FileText {
  std::string path;  // empty: there is none
  std::string text;
};

struct ScenarioAnswers {
  /// Of these files, and of the files in these folders, the scenarios that run one of these sources (FileIdentity).
  using OfProgram = std::function<std::vector<std::string>(const std::vector<std::string>& paths,
                                                           const std::vector<std::string>& sources)>;
  /// Why a signal is what it is at the end of a scenario, in lines; where that cannot be told: why not.
  using Why = std::function<std::string(const std::string& scenario, const std::string& signal)>;

  /// What is wrong with the plant and the panel of a program that has no errors.
  using MachineFaults = std::function<std::vector<yaml::Error>(const FileText& plant, const FileText& panel,
                                                               const compilation::Compilation& compilation)>;

  OfProgram of_program;
  Why why;
  MachineFaults machine_faults;
};

}  // namespace plcxx::lsp
