#include "transpiler/dialects/host50/parser/rung_machine.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plcxx::host50 {
namespace {

class RungMachine {
 public:
  RungMachine(Program& program, const source::SourceManager& sources, diag::Engine& diagnostics)
      : program_(program), sources_(sources), diagnostics_(diagnostics) {}

  void Execute(InstructionId id) {
    current_ = id;
    const Instruction& instruction = program_.instructions[id];
    if (instruction.unknown) {
      suspended_ = true;
      return;
    }
    const RungEffect effect = Info(instruction.op).effect;
    if (effect == RungEffect::kNothing) return;
    if (effect == RungEffect::kClose) {
      EndRung();
      Reset();
      return;
    }
    if (suspended_) return;
    Act(effect);
    last_ = id;
  }

  /// RUNG and the end of a network.
  void EndRung() {
    if (!suspended_) CheckRung();
  }

 private:
  struct Branch {
    InstructionId result;
    InstructionId mps;
  };

  void Reset() {
    acc_.reset();
    live_ = suspended_ = false;
    blocks_.clear();
    branches_.clear();
    last_.reset();
  }

  const InstructionInfo& InfoOf(InstructionId id) const { return Info(program_.instructions[id].op); }
  std::string Mnemonic(InstructionId id) const {
    return std::string(sources_.Text(program_.instructions[id].mnemonic));
  }

  /// Suspends the machine. `place` is the instruction that has the fault: it reports one error at most.
  template <class... Args>
  void Fault(InstructionId place, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    suspended_ = program_.faulty = true;
    Instruction& instruction = program_.instructions[place];
    if (!std::exchange(instruction.faulty, true)) diagnostics_.Report(instruction.range, message, args...);
  }

  void Act(RungEffect effect);
  void Load();
  void Series();
  void Parallel();
  void Join();
  void OpenBranch();
  void NextBranch(RungEffect effect);
  void Output();
  void BlockWithQ();
  void TakePins(Instruction& instruction);
  bool HasAcc();
  bool HasNoOpenBlock();
  void FaultOfOpenBlock(InstructionId place, const std::string& at);
  bool BranchIsUsed();
  bool CheckRung();

  /// ACC goes into the current instruction.
  void TakeAcc() {
    Input& input = program_.instructions[current_].input;
    input = {.kind = InputKind::kResults, .results = {static_cast<uint32_t>(program_.results.size()), 1}};
    program_.results.push_back(*acc_);
  }
  /// ACC is the result of the current instruction.
  void GiveAcc() {
    acc_ = current_;
    live_ = true;
  }

  Program& program_;
  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  InstructionId current_;
  std::optional<InstructionId> acc_;   // whose result it is
  std::optional<InstructionId> last_;  // of this rung, without REMARK
  bool live_ = false;
  bool suspended_ = false;
  std::vector<InstructionId> blocks_;  // BS
  std::vector<Branch> branches_;       // MS
};

void RungMachine::Act(RungEffect effect) {
  switch (effect) {
    case RungEffect::kLoad:
      return Load();
    case RungEffect::kSeries:
      return Series();
    case RungEffect::kParallel:
      return Parallel();
    case RungEffect::kJoinSeries:
    case RungEffect::kJoinParallel:
      return Join();
    case RungEffect::kBranchOpen:
      return OpenBranch();
    case RungEffect::kBranchNext:
    case RungEffect::kBranchLast:
      return NextBranch(effect);
    case RungEffect::kOutput:
      return Output();
    case RungEffect::kCompare:
    case RungEffect::kElement:
      return BlockWithQ();
    case RungEffect::kClose:
    case RungEffect::kNothing:
      break;
  }
  PLCXX_UNREACHABLE();
}

void RungMachine::Load() {
  if (live_) {
    blocks_.push_back(*acc_);
    if (blocks_.size() > kMostBlockDepth) return Fault(current_, diag::Host50BlocksTooDeep);
    if (blocks_.size() == kUsualBlockDepth + 1) {
      diagnostics_.Report(program_.instructions[current_].range, diag::Host50BlocksDeep);
    }
  } else if (!CheckRung()) {
    return;
  }
  GiveAcc();
}

bool RungMachine::HasAcc() {
  if (!acc_) Fault(current_, diag::Host50NoLoad, Mnemonic(current_));
  return acc_.has_value();
}

void RungMachine::Series() {
  if (!HasAcc()) return;
  TakeAcc();
  GiveAcc();
}

void RungMachine::Parallel() {
  if (!HasAcc()) return;
  if (!live_) return Fault(current_, diag::Host50OrAfterOutput, Mnemonic(current_));
  TakeAcc();
  GiveAcc();
}

void RungMachine::Join() {
  if (blocks_.empty() || !live_) return Fault(current_, diag::Host50WithoutOpenBlock, Mnemonic(current_));
  TakeAcc();
  program_.instructions[current_].other = blocks_.back();
  blocks_.pop_back();
  GiveAcc();
}

void RungMachine::FaultOfOpenBlock(InstructionId place, const std::string& at) {
  const InstructionId opened = blocks_.back();
  if (InfoOf(opened).effect == RungEffect::kElement) {
    Fault(place, diag::Host50OpenElement, at, Mnemonic(opened));
  } else {
    Fault(place, diag::Host50OpenBlock, at);
  }
}

bool RungMachine::HasNoOpenBlock() {
  if (!blocks_.empty()) FaultOfOpenBlock(current_, Mnemonic(current_));
  return blocks_.empty();
}

void RungMachine::OpenBranch() {
  if (!HasAcc() || !HasNoOpenBlock()) return;
  branches_.push_back({*acc_, current_});
  if (branches_.size() > kMostBranchDepth) return Fault(current_, diag::Host50BranchesTooDeep);
  if (branches_.size() == kUsualBranchDepth + 1) {
    diagnostics_.Report(program_.instructions[current_].range, diag::Host50BranchesDeep);
  }
  live_ = true;
}

/// MRD and MPP throw ACC away: what the branch has computed must have gone somewhere.
bool RungMachine::BranchIsUsed() {
  if (!live_ || !last_) return true;
  switch (InfoOf(*last_).effect) {
    case RungEffect::kBranchOpen:
    case RungEffect::kBranchNext:
    case RungEffect::kBranchLast:
    case RungEffect::kElement:
      return true;
    case RungEffect::kLoad:
    case RungEffect::kSeries:
    case RungEffect::kParallel:
    case RungEffect::kJoinSeries:
    case RungEffect::kJoinParallel:
    case RungEffect::kOutput:
    case RungEffect::kCompare:
    case RungEffect::kClose:
    case RungEffect::kNothing:
      return false;
  }
  PLCXX_UNREACHABLE();
}

void RungMachine::NextBranch(RungEffect effect) {
  if (branches_.empty()) return Fault(current_, diag::Host50WithoutMps, Mnemonic(current_));
  if (!HasNoOpenBlock()) return;
  if (!BranchIsUsed()) return Fault(*last_, diag::Host50BranchWithoutOutput, Mnemonic(current_));
  acc_ = branches_.back().result;
  live_ = true;
  if (effect == RungEffect::kBranchLast) branches_.pop_back();
}

void RungMachine::Output() {
  if (!HasAcc() || !HasNoOpenBlock()) return;
  TakeAcc();
  live_ = false;
}

void RungMachine::BlockWithQ() {
  if (!HasAcc()) return;
  TakePins(program_.instructions[current_]);
  GiveAcc();
}

/// The unnamed pins were loaded after the main input, in their order: the last one is ACC.
void RungMachine::TakePins(Instruction& instruction) {
  std::vector<Pin*> unnamed;
  for (uint32_t i = 0; i < instruction.pins.count; ++i) {
    Pin& pin = program_.pins[instruction.pins.first + i];
    if (pin.from_stack) unnamed.push_back(&pin);
  }
  if (blocks_.size() < unnamed.size()) {
    // Like a wrong operand: the rung goes on, as if the pins had been there.
    const Pin& missing = *unnamed[blocks_.size()];
    program_.faulty = true;
    if (!std::exchange(instruction.faulty, true)) {
      diagnostics_.Report(instruction.range, diag::Host50MissingPin, std::string(1, missing.name), Mnemonic(current_));
    }
    blocks_.clear();
    return TakeAcc();
  }
  for (; !unnamed.empty(); unnamed.pop_back()) {
    unnamed.back()->result = *acc_;
    acc_ = blocks_.back();
    blocks_.pop_back();
  }
  TakeAcc();
}

/// *Close rung*: what is open when a rung ends. True when it is complete.
bool RungMachine::CheckRung() {
  if (!branches_.empty()) {
    Fault(branches_.back().mps, diag::Host50MpsWithoutMpp);
    return false;
  }
  if (!blocks_.empty()) {
    FaultOfOpenBlock(*last_, "the end of the rung");
    return false;
  }
  if (live_ && InfoOf(*last_).effect != RungEffect::kElement) {
    Fault(*last_, diag::Host50RungWithoutOutput);
    return false;
  }
  return true;
}

}  // namespace

void EvaluateRungs(Program& program, NetworkId network, const source::SourceManager& sources,
                   diag::Engine& diagnostics) {
  const Span span = program.networks[network].instructions;
  if (span.count == 0) return;
  RungMachine machine(program, sources, diagnostics);
  for (uint32_t i = 0; i < span.count; ++i) machine.Execute(InstructionId(span.first + i));
  machine.EndRung();
}

}  // namespace plcxx::host50
