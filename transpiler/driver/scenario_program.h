// The programs that scenarios drive, each compiled once: scenarios of one machine share sources and options.
//
// In: what a scenario asks for. Out: its compilation and, when the scenario wants it, the generated code as a program
// of a platform. Safe to use from several threads.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/driver/compilation.h"
#include "transpiler/driver/compiled_engine.h"
#include "transpiler/driver/scenario.h"

namespace plcxx::driver {

/// What the command line says about every scenario's program.
struct ProgramOverrides {
  std::vector<std::string> sources;                          // instead of the scenario's own
  std::vector<std::pair<std::string, std::string>> options;  // the scenario's own win
  diag::WarningOptions warnings;
};

/// The request of a scenario. Warnings that it lists are switched on.
CompilationRequest RequestOf(const Scenario& scenario, const ProgramOverrides& overrides);

class ScenarioProgram {
 public:
  explicit ScenarioProgram(CompilationRequest request) : request_(std::move(request)) {}
  /// Of what is compiled already, which outlives the object.
  explicit ScenarioProgram(Compilation& compiled) : compiled_(&compiled) {}

  /// Compiled at the first call.
  Compilation& Compiled();
  /// The generated code, built at the first call for a platform. The compilation must be without errors.
  CompiledOrFailure On(const std::shared_ptr<const Platform>& platform);

 private:
  struct Built {
    std::once_flag once;
    CompiledOrFailure result;
  };

  CompilationRequest request_;
  std::once_flag compile_once_;
  Compilation compilation_;
  Compilation* compiled_ = nullptr;  // somebody else's
  std::mutex built_mutex_;
  std::map<std::string, Built> built_;  // by the platform's name
};

/// Gives scenarios with equal requests the same program, and forgets it after the last of them.
class ScenarioPrograms {
 public:
  explicit ScenarioPrograms(ProgramOverrides overrides) : overrides_(std::move(overrides)) {}

  /// Each scenario is announced once before the first Take.
  void Announce(const Scenario& scenario);
  std::shared_ptr<ScenarioProgram> Take(const Scenario& scenario);
  const ProgramOverrides& overrides() const { return overrides_; }

 private:
  struct Entry {
    std::shared_ptr<ScenarioProgram> program;
    size_t awaited = 0;  // scenarios that have not taken it yet
  };

  ProgramOverrides overrides_;
  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

}  // namespace plcxx::driver
