// The program that scenarios drive, compiled once: scenarios of one machine share sources and options.
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

#include "transpiler/compilation/compilation.h"
#include "transpiler/engines/compiled_program.h"
#include "transpiler/fleet/library.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {

/// What the command line says about every scenario's program.
struct ProgramOverrides {
  std::vector<std::string> sources;                          // instead of the scenario's own
  std::shared_ptr<const Scenario> program;                   // `sources` are this one: its program, with its options
  std::vector<std::pair<std::string, std::string>> options;  // before plcxx.yaml's; the scenario's own win
  diag::WarningOptions warnings;
};

/// What is wrong with one that names no program, where `sources` of the command line name none either; empty: it does.
std::string WhyNoProgram(const Scenario& scenario, const std::vector<std::string>& sources);

/// The request of a scenario. Warnings that it lists are switched on.
compilation::CompilationRequest RequestOf(const Scenario& scenario, const ProgramOverrides& overrides);

/// The flavour that its compiled engines execute: what users ship, unless it forces something.
emit::Flavour FlavourFor(const Scenario& scenario);

class ScenarioProgram {
 public:
  explicit ScenarioProgram(compilation::CompilationRequest request) : request_(std::move(request)) {}
  /// Of what is compiled already, which outlives the object.
  explicit ScenarioProgram(compilation::Compilation& compiled) : compiled_(&compiled) {}

  /// Compiled at the first call.
  compilation::Compilation& Compiled();
  /// The generated code, built at the first call for a platform. The compilation must be without errors.
  engines::CompiledOrFailure On(const std::shared_ptr<const engines::Platform>& platform, emit::Flavour flavour);
  /// The code of a fleet of them, built at the first call.
  fleet::LibraryOrFailure AsFleet(const fleet::LibraryRequest& request);
  /// It was built already, together with other programs (CompileTogether).
  void Give(const engines::Platform& platform, emit::Flavour flavour, engines::CompiledOrFailure built);

 private:
  struct Built {
    std::once_flag once;
    engines::CompiledOrFailure result;
  };
  Built& BuiltOn(const engines::Platform& platform, emit::Flavour flavour);

  compilation::CompilationRequest request_;
  std::once_flag compile_once_;
  compilation::Compilation compilation_;
  compilation::Compilation* compiled_ = nullptr;  // somebody else's
  std::mutex built_mutex_;
  std::map<bool, fleet::LibraryOrFailure> fleets_;                // with forces or without
  std::map<std::pair<std::string, emit::Flavour>, Built> built_;  // by the platform's name
};

/// All that distinguishes one request from another, as one text: scenarios of one machine share their program.
std::string KeyOf(const compilation::CompilationRequest& request);

}  // namespace plcxx::scenarios
