#include "transpiler/explanation/recorder.h"

#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::explanation {

ir::RoutineId RoutineOf(const ir::Program& program, PartKind kind) {
  switch (kind) {
    case PartKind::kPeriod:
      return program.schedule.period;
    case PartKind::kFast:
      return program.schedule.fast_only;
    case PartKind::kElapse:
      return program.schedule.elapse;
  }
  PLCXX_UNREACHABLE();
}

Recorder::Recorder(const ir::Program& program) : Simulator(program), program_(program) {
  RecordLastWrites();
  Recorder::AnswerHostCalls({});
}

void Recorder::PowerOn() {
  if (has_ended_) return;
  ++power_ons_;
  Simulator::PowerOn();
}

void Recorder::Run(PartKind kind, uint32_t now_ms, const std::function<void()>& part) {
  if (end_ms_ && now_ms > *end_ms_) has_ended_ = true;
  if (has_ended_) return;
  const auto number = static_cast<uint32_t>(parts_.size());
  parts_.push_back({.kind = kind, .now_ms = now_ms, .session = power_ons_ - 1});
  if (number != wanted_) {
    part();
    return;
  }
  Saved before = Save();
  sim::LastWrites writes = *last_writes();
  frame_.emplace(Frame{.kind = kind,
                       .now_ms = now_ms,
                       .before = before,
                       .after = before,
                       .calls = {},
                       .writes_before = std::move(writes)});
  is_recording_ = true;
  part();
  is_recording_ = false;
  frame_->after = Save();
  has_ended_ = true;
}

void Recorder::RunPeriod(uint32_t now_ms) {
  Run(PartKind::kPeriod, now_ms, [this, now_ms] { Simulator::RunPeriod(now_ms); });
}

void Recorder::RunFastOnly(uint32_t now_ms) {
  Run(PartKind::kFast, now_ms, [this, now_ms] { Simulator::RunFastOnly(now_ms); });
}

void Recorder::RunElapse(uint32_t now_ms) {
  Run(PartKind::kElapse, now_ms, [this, now_ms] { Simulator::RunElapse(now_ms); });
}

void Recorder::AnswerHostCalls(sim::HostAnswers answers) {
  Simulator::AnswerHostCalls(
      [this, answers = std::move(answers)](ir::HostFunctionId function, std::span<const uint64_t> arguments) {
        host_writes_ = 0;
        sim::HostAnswer answer = answers ? answers(function, arguments) : sim::HostAnswer{};
        if (!is_recording_) return answer;
        RecordedCall call{
            .function = function, .arguments = {arguments.begin(), arguments.end()}, .answer = answer, .memory = {}};
        if (host_writes_ != 0) {
          for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
            const std::span<const uint8_t> bytes = Memory(ir::SpaceId(i));
            call.memory.emplace_back(bytes.begin(), bytes.end());
          }
        }
        frame_->calls.push_back(std::move(call));
        return answer;
      });
}

void Recorder::Write(const ir::Place& place, uint64_t value) {
  if (has_ended_) return;
  ++host_writes_;
  Simulator::Write(place, value);
}

void Recorder::Force(const ir::Place& place, uint64_t value) {
  if (!has_ended_) Simulator::Force(place, value);
}

void Recorder::Release(const ir::Place& place) {
  if (!has_ended_) Simulator::Release(place);
}

void Recorder::SendText(std::string_view text) {
  if (!has_ended_) Simulator::SendText(text);
}

void Recorder::StoreRetentive() {
  if (!has_ended_) Simulator::StoreRetentive();
}

}  // namespace plcxx::explanation
