// The second reading of nc110: an interpreter of the syntax tree, from sections 4 to 7 of the specification.

#include "tests/reference/nc110_reference.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/reference/nc110_elements.h"
#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"

namespace plcxx::reference {
namespace {

using namespace nc110;           // the syntax tree
using namespace nc110_elements;  // section 7

constexpr uint32_t kBytesOfConnector = 4, kMostPasses = 255, kParameterRange = 0, kLoopLimit = 1;
constexpr uint32_t kLongestText = 32;

/// 5.1: connectors of each package, in the order of Package.
constexpr std::array<uint32_t, 4> kConnectors = {32, 256, 256, 16};
constexpr std::array<const char*, 4> kPackageNames = {"A", "K", "N", "T"};

/// 6.6
uint8_t Encode(uint8_t w) {
  uint8_t position = 0;
  for (uint8_t bit = 0; bit < 8; ++bit) {
    if ((w >> bit & 1) != 0) position = static_cast<uint8_t>(bit + 1);
  }
  return position;
}
uint8_t Decode(uint8_t w) { return w >= 1 && w <= 8 ? static_cast<uint8_t>(1u << (w - 1)) : uint8_t{0}; }
uint8_t ToBcd(uint8_t w) { return static_cast<uint8_t>(w % 100 / 10 * 16 + w % 100 % 10); }
uint8_t FromBcd(uint8_t w) { return static_cast<uint8_t>(w / 16 * 10 + w % 16); }
uint8_t Absolute(uint8_t a) { return a < 128 ? a : static_cast<uint8_t>(256 - a); }

class Nc110 : public Reference {
 public:
  Nc110(dialects::Request& request, HostCalls host)
      : Reference(std::move(host)), settings_(ReadSettings(request)), slices_(settings_.slices) {
    tree_ = Parse(*request.sources, request.files, settings_.parse, *request.diagnostics);
    for (uint32_t i = 0; i < kConnectors.size(); ++i) {
      memories_.emplace_back(kPackageNames[i], kConnectors[i] * kBytesOfConnector);
      latched_.emplace_back(kConnectors[i] * kBytesOfConnector);
    }
    for (const Literal& literal : tree_.literals) texts_.emplace_back(request.sources->Text(literal.range));
    fast_end_ = tree_.first_cycle_mark.valid() ? tree_.first_cycle_mark.index : tree_.items.size();
    for (uint32_t i = 0; i < tree_.items.size(); ++i) {
      const Item& item = tree_.items[ItemId(i)];
      if (item.kind != ItemKind::kAssignment) continue;
      const Operand& target = tree_.assignments[item.assignment()].target.operand;
      if (target.kind == OperandKind::kCounterInput) counts_in_[i < fast_end_ ? 0 : 1][target.number] = true;
      if (target.kind == OperandKind::kOneShot) pulses_in_[i < fast_end_ ? 0 : 1][target.number] = true;
    }
  }

  void Take(const Choices& choices) override {
    choices_ = choices;
    slices_ = std::max(1u, choices.slice_count);
  }

  // 4.5
  void PowerOn() override {
    for (AddressSpace& package : memories_) package.Clear();
    timers_.fill({});
    counters_.fill({});
    one_shots_.fill({});
    left_.assign(texts_.size(), 0);
    pending_.reset();
    cycles_ = {};
    slice_ = 0;
    for (uint32_t i = 0; i < kRetainedBytes; ++i) PackageT().Write(i, 0xFF, settings_.t_initial[i].value_or(0));
    if (settings_.retention && stored_) {
      for (uint32_t i = 0; i < kRetainedBytes; ++i) PackageT().Write(i, 0xFF, (*stored_)[i]);
    }
    machine_off_ = save_ = false;
    PutBackForced();
  }

  // 4.3
  void RunPeriod(uint32_t now_ms) override {
    now_ = now_ms;
    Call("read_inputs");
    Fast();
    if (slice_ == 0) {
      ++cycles_.slow_cycle;
      UpdateTexts();
      if (settings_.latch_slow_inputs) {
        for (size_t i = 0; i < latched_.size(); ++i) latched_[i] = memories_[i].bytes();
      }
    }
    part_ = Part::kSlow;
    RunSlice();
    if (++slice_ == slices_) {
      slice_ = 0;
      ++cycles_.slow_done;
      Expire(Part::kSlow);
    }
    Call("write_outputs");
    RequestStore();
  }

  // 4.4, where the request to store package T is not on the list
  void RunFastOnly(uint32_t now_ms) override {
    now_ = now_ms;
    Call("read_inputs");
    Fast();
    Call("write_outputs");
  }

  void SendText(std::string_view text) override { pending_ = std::string(text); }

  void StoreRetentive() override { stored_ = PackageT().bytes(); }

  std::optional<Element> FindElement(std::string_view instance, std::string_view field) override {
    const auto number = static_cast<size_t>(std::atoi(std::string(instance.substr(1)).c_str()));
    const auto bit = [](bool& value) {
      return Element{[&value] { return uint64_t{value}; }, [&value](uint64_t v) { value = v != 0; }};
    };
    if (instance.starts_with('T') && number < timers_.size()) {
      Timer& timer = timers_[number];
      if (field == "input") return bit(timer.input);
      if (field == "hold") return bit(timer.hold);
      if (field == "done") return bit(timer.elapsed_output);
      if (field == "timing") return bit(timer.running);
    } else if (instance.starts_with('C') && number < counters_.size()) {
      Counter& counter = counters_[number];
      if (field == "input") return bit(counter.input);
      if (field == "down") return bit(counter.down);
      if (field == "reset") return bit(counter.reset);
      if (field == "carry") return bit(counter.carry);
      if (field == "count") {
        return Element{[&counter] { return uint64_t{counter.count}; },
                       [&counter](uint64_t v) { counter.count = static_cast<uint8_t>(v); }};
      }
    } else if (instance.starts_with('P') && number < one_shots_.size()) {
      OneShot& one_shot = one_shots_[number];
      if (field == "pulse") return bit(one_shot.pulse);
      if (field == "previous") return bit(one_shot.previous);
    }
    return std::nullopt;
  }

 private:
  // --- the schedule (4.3) ---

  void Fast() {
    part_ = Part::kFast;
    ++cycles_.fast_executions;
    cycles_.slow_in_progress = slice_ != 0;
    Execute(0, fast_end_);
    Expire(Part::kFast);
  }

  /// A slice boundary lies between two items at the top level, in the order of the source (4.2).
  void RunSlice() {
    uint32_t slice = 0;
    for (uint32_t i = fast_end_; i < tree_.items.size();) {
      const auto known = choices_.slices.find(tree_.items[ItemId(i)].range.begin);
      if (known != choices_.slices.end()) slice = known->second;
      const uint32_t next = After(i);
      if (slice == slice_) Execute(i, next);
      i = next;
    }
  }

  void Expire(Part ended) {
    for (size_t i = 0; i < counters_.size(); ++i) {
      const bool of_part = counts_in_[ended == Part::kFast ? 0 : 1][i];
      if (of_part && settings_.carry == CarryEnd::kScan) counters_[i].Expire(ended, cycles_);
    }
    // One that the host has set, and no statement of the part starts, is not the part's.
    for (size_t i = 0; i < one_shots_.size(); ++i) {
      if (pulses_in_[ended == Part::kFast ? 0 : 1][i]) one_shots_[i].Expire(ended, cycles_);
    }
    PutBackForced();
  }

  void UpdateTexts() {  // 7.5
    for (size_t i = 0; i < texts_.size(); ++i) {
      if (pending_) {
        left_[i] = texts_[i] == *pending_ && pending_->size() <= kLongestText ? 2 : 0;
      } else if (left_[i] > 0) {
        --left_[i];
      }
    }
    pending_.reset();
  }

  void RequestStore() {  // 4.5: U10K0, U10N4
    const bool machine_off = (Of(Package::kK)[10 * kBytesOfConnector] & 1) != 0;
    const bool save = (Of(Package::kN)[10 * kBytesOfConnector] >> 4 & 1) != 0;
    const bool wanted = (settings_.retention && machine_off && !machine_off_) || (save && !save_);
    machine_off_ = machine_off;
    save_ = save;
    if (!wanted) return;
    StoreRetentive();
    Call("retentive_store");
  }

  // --- items (3, 6.8) ---

  /// The item that follows in the same body: a chain of blocks is one.
  uint32_t After(uint32_t item) const {
    if (tree_.items[ItemId(item)].kind != ItemKind::kBlockHead) return item + 1;
    BlockId block = tree_.items[ItemId(item)].block();
    while (tree_.blocks[block].next.valid()) block = tree_.blocks[block].next;
    return tree_.blocks[block].end.index + 1;
  }

  void Execute(uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; i = After(i)) {
      const Item& item = tree_.items[ItemId(i)];
      if (item.kind == ItemKind::kAssignment) Assign(tree_.assignments[item.assignment()]);
      if (item.kind == ItemKind::kBlockHead) Chain(item.block());
    }
  }

  void Body(const Block& block) { Execute(block.head.index + 1, block.end.index); }

  void Chain(BlockId id) {
    if (tree_.blocks[id].kind == BlockKind::kDow) {
      Loop(tree_.blocks[id]);
      return;
    }
    for (; id.valid(); id = tree_.blocks[id].next) {
      const Block& block = tree_.blocks[id];
      if (block.condition.valid() && !Signal(block.condition)) continue;
      Body(block);
      return;
    }
  }

  void Loop(const Block& block) {  // D24
    for (uint32_t passes = 0; Signal(block.condition); ++passes) {
      if (passes == kMostPasses) {
        const auto id = choices_.statement_ids.find(tree_.items[block.head].range.begin);
        Call("fault", {kLoopLimit, id == choices_.statement_ids.end() ? 0 : id->second});
        return;
      }
      Body(block);
    }
  }

  void Assign(const Assignment& assignment) {
    const Operand& target = assignment.target.operand;
    if (TypeOf(target.kind) == Type::kWord) {
      if (const std::optional<uint8_t> value =
              assignment.mux.valid() ? Selected(assignment.mux) : Word(assignment.value)) {
        AssignWord(target, *value);
      }
    } else {
      AssignSignal(target, Signal(assignment.value) != assignment.inverted, assignment.parameter);
    }
    PutBackForced();
  }

  std::optional<uint8_t> Selected(MuxId id) {  // 6.7
    const Mux& mux = tree_.muxes[id];
    for (uint32_t i = mux.first; i < mux.first + mux.count; ++i) {
      if (Signal(tree_.mux_inputs[i].selector)) return Word(tree_.mux_inputs[i].word);
    }
    return std::nullopt;
  }

  void AssignWord(const Operand& target, uint8_t value) {
    if (target.kind == OperandKind::kCounterValue) {
      counters_[target.number].count = value;
    } else {
      Write(target.package, target.number * kBytesOfConnector + target.index, 0xFF, value);
    }
  }

  void AssignSignal(const Operand& target, bool value, ExprId parameter) {
    switch (target.kind) {
      case OperandKind::kOutput:
        Write(target.package, target.number * kBytesOfConnector + target.index / 8u,
              static_cast<uint8_t>(1u << target.index % 8), value ? 0xFF : 0);
        return;
      case OperandKind::kTimerInput:
        timers_[target.number].Step(value, PresetMs(target.number, parameter), now_);
        return;
      case OperandKind::kTimerHold:
        timers_[target.number].hold = value;
        return;
      case OperandKind::kCounterInput:
        if (!counters_[target.number].Step(value, Parameter(parameter), CarryMode(), part_, cycles_)) {
          Call("fault", {kParameterRange, target.number});
        }
        return;
      case OperandKind::kCounterReset:
        counters_[target.number].Reset(value);
        return;
      case OperandKind::kCounterDown:
        counters_[target.number].down = value;
        return;
      case OperandKind::kOneShot:
        if (part_ == Part::kFast) {
          one_shots_[target.number].StepFast(value, cycles_);
        } else {
          one_shots_[target.number].StepSlow(value, cycles_);
        }
        return;
      case OperandKind::kNone:
      case OperandKind::kInput:
      case OperandKind::kWord:
      case OperandKind::kTimerElapsed:
      case OperandKind::kTimerRunning:
      case OperandKind::kCounterCarry:
      case OperandKind::kCounterValue:
        Unsupported("assignment to " + ToText(target));
        return;
    }
  }

  Carry CarryMode() const {
    switch (settings_.carry) {
      case CarryEnd::kScan:
        return Carry::kScan;
      case CarryEnd::kInput:
        return Carry::kInput;
      case CarryEnd::kNext:
        return Carry::kNext;
    }
    return Carry::kScan;
  }

  /// A constant, or a pair of words, the lower one first (5.4).
  uint32_t Parameter(ExprId id) const {
    const Expr& expr = tree_.exprs[id];
    if (expr.kind == ExprKind::kConstant) return expr.value;
    const uint32_t low = expr.operand.number * kBytesOfConnector + expr.operand.index;
    return Byte(expr.operand.package, low) + 256u * Byte(expr.operand.package, low + 1);
  }

  uint64_t PresetMs(uint32_t timer, ExprId parameter) const {  // 7.1
    const bool is_short = timer >= 48 && timer <= 63;
    const uint64_t units = Parameter(parameter);
    if (tree_.exprs[parameter].kind == ExprKind::kConstant) return units * (is_short ? 10 : 100);
    return units * settings_.tim_ms * (is_short ? 1 : 10);
  }

  // --- expressions (6) ---

  bool Signal(ExprId id) {
    const Expr& expr = tree_.exprs[id];
    switch (expr.kind) {
      case ExprKind::kOperand:
        return ReadSignal(expr.operand);
      case ExprKind::kConstant:
        return expr.value != 0;
      case ExprKind::kAscii:
        return left_[expr.literal.index] > 0;
      case ExprKind::kNot:
        return !Signal(expr.left);
      case ExprKind::kAnd:
        return Signal(expr.left) && Signal(expr.right);
      case ExprKind::kOr:
        return Signal(expr.left) || Signal(expr.right);
      case ExprKind::kXor:
        return Signal(expr.left) != Signal(expr.right);
      case ExprKind::kLess:
        return Word(expr.left) < Word(expr.right);
      case ExprKind::kEqual:
        return Word(expr.left) == Word(expr.right);
      case ExprKind::kGreater:
        return Word(expr.left) > Word(expr.right);
      case ExprKind::kSgn:
        return Word(expr.left) >= 128;
      default:
        Unsupported("a word where a signal is needed");
        return false;
    }
  }

  uint8_t Word(ExprId id) {
    const Expr& expr = tree_.exprs[id];
    const auto left = [&] { return Word(expr.left); };
    const auto right = [&] { return Word(expr.right); };
    switch (expr.kind) {
      case ExprKind::kOperand:
        if (expr.operand.kind == OperandKind::kCounterValue) return counters_[expr.operand.number].count;
        return Byte(expr.operand.package, expr.operand.number * kBytesOfConnector + expr.operand.index);
      case ExprKind::kConstant:
        return expr.value;
      case ExprKind::kNot:
        return static_cast<uint8_t>(~left());
      case ExprKind::kAnd:
        return static_cast<uint8_t>(left() & right());
      case ExprKind::kOr:
        return static_cast<uint8_t>(left() | right());
      case ExprKind::kXor:
        return static_cast<uint8_t>(left() ^ right());
      case ExprKind::kAdd:
        return static_cast<uint8_t>(left() + right());
      case ExprKind::kSubtract:
        return static_cast<uint8_t>(left() - right());
      case ExprKind::kEnc:
        return Encode(left());
      case ExprKind::kDec:
        return Decode(left());
      case ExprKind::kBcd:
        return ToBcd(left());
      case ExprKind::kBin:
        return FromBcd(left());
      case ExprKind::kHig:
        return static_cast<uint8_t>(left() / 16);
      case ExprKind::kLow:
        return static_cast<uint8_t>(left() % 16);
      case ExprKind::kXch:
        return static_cast<uint8_t>(left() % 16 * 16 + left() / 16);
      case ExprKind::kAbs:
        return Absolute(left());
      default:
        Unsupported("a signal where a word is needed");
        return 0;
    }
  }

  bool ReadSignal(const Operand& operand) const {
    switch (operand.kind) {
      case OperandKind::kInput:
      case OperandKind::kOutput:
        return (Byte(operand.package, operand.number * kBytesOfConnector + operand.index / 8u) >> operand.index % 8 &
                1) != 0;
      case OperandKind::kTimerInput:
        return timers_[operand.number].input;
      case OperandKind::kTimerHold:
        return timers_[operand.number].hold;
      case OperandKind::kTimerElapsed:
        return timers_[operand.number].elapsed_output;
      case OperandKind::kTimerRunning:
        return timers_[operand.number].running;
      case OperandKind::kCounterInput:
        return counters_[operand.number].input;
      case OperandKind::kCounterCarry:
        return counters_[operand.number].carry;
      case OperandKind::kCounterReset:
        return counters_[operand.number].reset;
      case OperandKind::kCounterDown:
        return counters_[operand.number].down;
      case OperandKind::kOneShot:
        return one_shots_[operand.number].pulse;
      case OperandKind::kNone:
      case OperandKind::kWord:
      case OperandKind::kCounterValue:
        return false;
    }
    return false;
  }

  // --- memory (5) ---

  AddressSpace& Of(Package package) { return memories_[static_cast<size_t>(package)]; }
  AddressSpace& PackageT() { return Of(Package::kT); }

  /// 5.3: input connectors of the machine, signals from the control, keys of the panel.
  bool IsInput(Package package, uint32_t connector) const {
    if (package == Package::kA) return connector < 20 && connector / 4 % 2 == 0;
    if (package == Package::kT) return false;
    if (package == Package::kK && (connector == 157 || connector == 158)) return true;
    return connector < 26 * settings_.processes && connector % 26 < 10;
  }

  /// 4.3: with latched inputs the slow part sees those of slice 0. A force stands for an input there: one that is set
  /// in the middle of a slow cycle is seen from the next one on.
  uint8_t Byte(Package package, uint32_t offset) const {
    const auto index = static_cast<size_t>(package);
    const bool latched =
        settings_.latch_slow_inputs && part_ == Part::kSlow && IsInput(package, offset / kBytesOfConnector);
    return latched ? latched_[index][offset] : memories_[index][offset];
  }

  /// 4.1: what the program writes is there at once for both parts; a forced bit keeps its value.
  void Write(Package package, uint32_t offset, uint8_t mask, uint8_t value) {
    const auto index = static_cast<size_t>(package);
    memories_[index].Write(offset, mask, value);
    latched_[index][offset] =
        static_cast<uint8_t>((latched_[index][offset] & ~mask) | (memories_[index][offset] & mask));
  }

  Settings settings_;
  nc110::Program tree_;
  Choices choices_;
  uint32_t slices_ = 1;
  uint32_t fast_end_ = 0;
  std::vector<std::string> texts_;  // by LiteralId
  std::vector<uint8_t> left_;       // slow cycles for which its flag is 1
  std::optional<std::string> pending_;
  std::optional<std::vector<uint8_t>> stored_;
  std::vector<std::vector<uint8_t>> latched_;  // by package: inputs as the slow part sees them
  std::array<Timer, 255> timers_{};
  std::array<Counter, 100> counters_{};
  std::array<std::array<bool, 100>, 2> counts_in_{};  // the fast part, the slow part: counters with a statement there
  std::array<std::array<bool, 100>, 2> pulses_in_{};  // likewise: one-shots
  std::array<OneShot, 100> one_shots_{};
  Cycles cycles_;
  uint32_t slice_ = 0;  // j
  uint32_t now_ = 0;
  Part part_ = Part::kSlow;
  bool machine_off_ = false, save_ = false;  // U10K0, U10N4 at the end of the last period
};

}  // namespace

std::unique_ptr<Reference> MakeNc110(dialects::Request& request, HostCalls host) {
  return std::make_unique<Nc110>(request, std::move(host));
}

}  // namespace plcxx::reference
