#include "transpiler/live/machine.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace plcxx::live {
namespace {

/// Of real time, for a stretch that the program does not end.
constexpr std::chrono::seconds kLongest{2};

}  // namespace

Machine::Machine(const compilation::Compilation& compilation)
    : Machine(compilation, std::make_unique<sim::Simulator>(compilation.program)) {}

Machine::Machine(const compilation::Compilation& compilation, std::unique_ptr<sim::Simulator> simulator)
    : compilation_(compilation),
      simulator_(std::move(simulator)),
      control_(compilation.program, *compilation.dialect, *simulator_, scenarios::StubOf(compilation)),
      clock_(compilation.program, {simulator_.get()}),
      off_(compilation.program.statements.size()),
      executed_(compilation.program.statements.size()) {
  simulator_->RecordLastWrites();
  clock_.before_period = [this](uint32_t now_ms) { control_.BeforePeriod(now_ms); };
  clock_.after_period = [this](uint32_t now_ms) {
    if (!simulator_->stopped()) control_.AfterPeriod(now_ms);
  };
}

void Machine::PowerOn() {
  clock_.PowerOn();
  control_.PowerOn();
}

void Machine::PowerCycle() {
  control_.PowerOff();
  clock_.PowerCycle();
  control_.PowerOn();
}

void Machine::RunAgain(const Advance& advance) {
  constexpr uint32_t kMost = std::numeric_limits<uint32_t>::max();
  switch (advance.kind) {
    case AdvanceKind::kMs:
      clock_.RunMs(advance.ms);
      return;
    case AdvanceKind::kSlowPeriod:
    case AdvanceKind::kFastPeriod: {
      // Interrupted after its first period, so that it can be looked at between any two.
      auto interrupted = std::exchange(clock_.interrupted, [] { return true; });
      if (advance.kind == AdvanceKind::kSlowPeriod) {
        clock_.RunSlow(kMost);
      } else {
        clock_.RunFast(kMost);
      }
      clock_.interrupted = std::move(interrupted);
      return;
    }
  }
}

void Machine::BeginStretch(const StopAt& stop) {
  ++stretch_;
  simulator_->AtStatements([this, &stop](ir::StatementId statement) {
    if (stop && stop(statement)) return true;
    executed_[statement.index] = stretch_;
    return false;
  });
  const auto end = std::chrono::steady_clock::now() + kLongest;
  simulator_->StopWhen([end] { return std::chrono::steady_clock::now() > end; });
}

void Machine::ComputeAgain(uint32_t now_ms) {
  const StopAt no_stop;
  BeginStretch(no_stop);
  simulator_->RunPeriod(now_ms);
  simulator_->AtStatements({});
}

bool Machine::Run(const Advance& advance, const StopAt& stop) {
  BeginStretch(stop);
  clock_.interrupted = [this] { return simulator_->stopped(); };
  RunAgain(advance);
  simulator_->AtStatements({});
  return !simulator_->stopped();
}

void Machine::Force(const dialects::Location& location, uint64_t value) {
  for (const auto& [place, part] : scenarios::WritesTo(location, value)) simulator_->Force(place, part);
}

void Machine::Release(const dialects::Location& location) {
  for (const auto& [place, part] : scenarios::WritesTo(location, 0)) simulator_->Release(place);
}

void Machine::EnableStatement(ir::StatementId statement, bool enabled) {
  simulator_->EnableStatement(statement, enabled);
  off_[statement.index] = !enabled;
}

uint64_t Machine::Read(const dialects::Location& location) { return location.absent ? 0 : control_.Read(location); }

Machine::Saved Machine::Save() const {
  return {.simulator = simulator_->Save(),
          .noted = simulator_->SaveNoted(),
          .control = control_.Save(),
          .messages = control_.active_messages(),
          .off = off_,
          .time_ms = clock_.time_ms()};
}

void Machine::Restore(const Saved& saved) {
  simulator_->Restore(saved.simulator);
  simulator_->RestoreNoted(saved.noted);
  control_.Restore(saved.control);
  control_.RestoreMessages(saved.messages);
  for (uint32_t i = 0; i < saved.off.size(); ++i) simulator_->EnableStatement(ir::StatementId(i), !saved.off[i]);
  off_ = saved.off;
  clock_.GoTo(saved.time_ms);
}

}  // namespace plcxx::live
