// What has changed since a page was told last: one for each page that looks.
//
// In: the session. Out: JSON with what is different from what this page knows; the first one has everything. Not its
// job: sending it.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "transpiler/live/program_view.h"
#include "transpiler/live/session.h"

namespace plcxx::live {

class StateView {
 public:
  /// Both outlive it.
  StateView(Session& session, const ProgramView& program) : session_(session), program_(program) {}

  nlohmann::ordered_json Changes();

 private:
  void AddWhereItIs(nlohmann::ordered_json& state);
  void AddValues(nlohmann::ordered_json& state);
  void AddPower(nlohmann::ordered_json& state);
  void AddExecuted(nlohmann::ordered_json& state);
  void AddChart(nlohmann::ordered_json& state);
  void AddNotes(nlohmann::ordered_json& state);
  /// A part that is sent where it differs from what was sent.
  void AddPart(nlohmann::ordered_json& state, const char* key, nlohmann::ordered_json value);

  Session& session_;
  const ProgramView& program_;
  std::vector<uint64_t> values_;
  std::vector<std::string> texts_;  // of instances
  std::vector<bool> is_known_, power_, executed_;
  bool has_power_ = false, has_executed_ = false, has_notes_ = false, has_chart_ = false;
  nlohmann::ordered_json parts_;
  uint32_t notes_version_ = 0, chart_version_ = 0;
  uint64_t next_sample_ = 0;  // period of the first sample that was not sent
};

}  // namespace plcxx::live
