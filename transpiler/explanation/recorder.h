// A simulator that keeps one part of what it executes as a Frame, and stops there.
//
// In: which part, by its number since the beginning, or a time. Out: the frame, and the times of all parts. After the
// end nothing changes any more, whatever the caller runs or writes: a scenario may go on as if nothing had happened.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "transpiler/explanation/frame.h"

namespace plcxx::explanation {

class Recorder : public sim::Simulator {
 public:
  /// What has been executed.
  struct Part {
    PartKind kind{};
    uint32_t now_ms = 0;
    uint32_t session = 0;  // power-ons before it, without the first one
  };

  explicit Recorder(const ir::Program& program);

  /// The part of this number is kept, and the last one that is executed.
  void EndAfterPart(uint32_t number) { wanted_ = number; }
  /// No part after this time is executed.
  void EndAt(uint64_t time_ms) { end_ms_ = time_ms; }

  const std::vector<Part>& parts() const { return parts_; }
  bool has_run_since_power_on() const { return !parts_.empty() && parts_.back().session + 1 == power_ons_; }
  bool has_ended() const { return has_ended_; }
  /// None: that part was not executed.
  std::optional<Frame>& frame() { return frame_; }

  void PowerOn() override;
  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void RunElapse(uint32_t now_ms) override;
  void AnswerHostCalls(sim::HostAnswers answers) override;
  void Write(const ir::Place& place, uint64_t value) override;
  void Force(const ir::Place& place, uint64_t value) override;
  void Release(const ir::Place& place) override;
  void SendText(std::string_view text) override;
  void StoreRetentive() override;

 private:
  void Run(PartKind kind, uint32_t now_ms, const std::function<void()>& part);

  const ir::Program& program_;
  std::vector<Part> parts_;
  std::optional<uint32_t> wanted_;
  std::optional<uint64_t> end_ms_;
  std::optional<Frame> frame_;
  uint32_t power_ons_ = 0;
  uint32_t host_writes_ = 0;
  bool is_recording_ = false;
  bool has_ended_ = false;
};

}  // namespace plcxx::explanation
