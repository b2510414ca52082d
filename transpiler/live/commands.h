// The commands of the page: JSON from outside, of which nothing is believed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "transpiler/live/session.h"

namespace plcxx::live {

/// What a command gives: a refusal, or what it was asked for (mostly nothing).
struct CommandResult {
  Refusal refusal;
  nlohmann::ordered_json answer;
};

/// What scenarios that are recorded need.
struct RecordingPlace {
  compilation::Compilation* compilation = nullptr;
  const compilation::CompilationRequest* request = nullptr;
  std::string directory;  // where scenarios are saved
};

CommandResult RunCommand(Session& session, const RecordingPlace& place, const nlohmann::ordered_json& command);

/// All that there are, for the documentation and its test.
std::vector<std::string> CommandNames();

}  // namespace plcxx::live
