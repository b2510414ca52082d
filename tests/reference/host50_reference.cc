// The second reading of host50: an interpreter of the syntax tree, from sections 4 to 8 of the specification. The rung
// machine of 6.1 runs here as the table says, with stacks; what the tree knows of it serves drawings alone.

#include "tests/reference/host50_reference.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/host50_elements.h"
#include "tests/reference/host50_machine.h"
#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::reference {
namespace {

using namespace host50;           // the syntax tree
using namespace host50_elements;  // section 7

constexpr uint32_t kMostBackwardJumps = 10'000;
enum class Fault : uint8_t { kJumpLoop, kRotRange, kAxisRange };

/// What an axis block has sent (6.8).
struct AxisState {
  bool active = false;
  uint32_t axis = 0;
  std::array<uint32_t, 3> sent{};  // method, position, speed
};

/// Of a part of an axis request (6.8). Two NaNs are the same: which one an operation yields is the processor's choice.
bool SentAlready(uint32_t wanted, uint32_t sent, bool real) {
  return wanted == sent || (real && std::isnan(std::bit_cast<float>(wanted)) && std::isnan(std::bit_cast<float>(sent)));
}

class Host50 : public Host50Machine {
 public:
  Host50(dialects::Request& request, HostCalls host) : Host50Machine(request, std::move(host)) {
    edges_.resize(tree_.instructions.size());
    results_.resize(tree_.instructions.size());
    fast_ = FindSection(tree_, SectionKind::kFast);
    slow_ = FindSection(tree_, SectionKind::kSlow);
    if (slow_.valid()) Weigh();
    for (uint32_t i = 0; i < tree_.instructions.size(); ++i) WatchAlarms(InstructionId(i));
  }

  // 4.3
  void PowerOn() override {
    for (AddressSpace& space : memories_) space.Clear();
    if (stored_) image_.PutBack(*stored_);
    timers_.fill({});
    counters_.fill({});
    axes_.clear();
    alarms_.fill(false);
    Call("read_inputs");
    PutBackForced();
    for (uint32_t i = 0; i < tree_.instructions.size(); ++i) {
      const InstructionId id(i);
      if (!IsEdge(tree_.instructions[id].op)) continue;
      edges_[i] = tree_.settings.edgeinit == EdgeInitOption::kImage && Bit(OperandOf(id, 0));
    }
    tick_ = next_network_ = backward_ = 0;
    slow_ended_ = false;
  }

  void RunPeriod(uint32_t /*now_ms*/) override {
    Call("read_inputs");
    period_ = 1;
    if (fast_.valid()) RunSection(fast_);
    period_ = tree_.settings.slowdiv;
    const uint32_t piece = tick_ % tree_.settings.slowdiv;
    if (tree_.settings.slices == SlicesOption::kSliced) {
      RunSlice(piece);
    } else if (piece == tree_.settings.slowdiv - 1 && slow_.valid()) {
      RunSection(slow_);
    }
    Call("write_outputs");
    for (uint32_t i = 0; i < alarms_.size(); ++i) {
      const bool on = image_.Bit(Area::kQ, 400 + i);
      if (on != alarms_[i] && watched_alarms_[i]) Call("alarm", {i, on ? 1u : 0u});
      alarms_[i] = on;
    }
    ++tick_;
  }

  /// `{fast: k}` runs ticks as well.
  void RunFastOnly(uint32_t now_ms) override { RunPeriod(now_ms); }

  void StoreRetentive() override { stored_ = image_.Retentive(); }

  std::optional<Element> FindElement(std::string_view instance, std::string_view field) override {
    const auto known = [&](auto& element) -> std::optional<Element> {
      const auto word = [](int32_t& value) {
        return Element{[&value] { return uint64_t{static_cast<uint32_t>(value)}; },
                       [&value](uint64_t v) { value = static_cast<int32_t>(static_cast<uint32_t>(v)); }};
      };
      if (field == "value") return word(element.value);
      if (field == "preset") return word(element.preset);
      if (field != "output") return std::nullopt;
      return Element{[&element] { return uint64_t{element.q}; }, [&element](uint64_t v) { element.q = v != 0; }};
    };
    const auto number = [&](size_t letters) {
      const std::string digits(instance.substr(letters));
      return digits.find_first_not_of("0123456789") == std::string::npos ? std::strtoul(digits.c_str(), nullptr, 10)
                                                                         : timers_.size();
    };
    if (instance.starts_with("TM") && number(2) < timers_.size()) return known(timers_[number(2)]);
    if (instance.starts_with('C') && number(1) < counters_.size()) return known(counters_[number(1)]);
    // Else it has the name of its symbol: one that looks like an address would be mistaken for it.
    for (const Symbol& symbol : tree_.symbols) {
      if (symbol.name != instance) continue;
      if (symbol.address.area == Area::kTm) return known(timers_[symbol.address.number]);
      if (symbol.address.area == Area::kC) return known(counters_[symbol.address.number]);
    }
    return std::nullopt;
  }

 private:
  // --- sections, networks, slices (4) ---

  /// SLICED: the network belongs to slice floor(n * (weights before it) / (all weights)).
  void Weigh() {
    const Span networks = tree_.sections[slow_].networks;
    std::vector<uint64_t> before;
    uint64_t sum = 0;
    for (uint32_t i = 0; i < networks.count; ++i) {
      before.push_back(sum);
      uint64_t weight = 0;
      const Network& network = tree_.networks[NetworkId(networks.first + i)];
      for (uint32_t k = 0; k < network.instructions.count; ++k) {
        const Op op = tree_.instructions[InstructionId(network.instructions.first + k)].op;
        weight += op == Op::kRemark || op == Op::kRung ? 0 : 1;
      }
      sum += std::max<uint64_t>(1, weight);
    }
    for (const uint64_t weights : before) {
      slices_.push_back(static_cast<uint32_t>(tree_.settings.slowdiv * weights / sum));
    }
  }

  void RunSection(SectionId id) {
    const Span networks = tree_.sections[id].networks;
    uint32_t jumps = 0;
    for (uint32_t i = 0; i < networks.count;) {
      const std::optional<uint32_t> next = RunNetwork(id, i, jumps);
      if (!next) return;
      i = *next;
    }
  }

  void RunSlice(uint32_t slice) {
    if (slice == 0) {
      next_network_ = backward_ = 0;
      slow_ended_ = false;
    }
    while (!slow_ended_ && next_network_ < slices_.size() && slices_[next_network_] <= slice) {
      const std::optional<uint32_t> next = RunNetwork(slow_, next_network_, backward_);
      slow_ended_ = !next;
      next_network_ = next.value_or(0);
    }
  }

  /// The position of the network that follows; none: the section ends here (4.8).
  std::optional<uint32_t> RunNetwork(SectionId id, uint32_t position, uint32_t& jumps) {
    const Section& section = tree_.sections[id];
    const NetworkId network(section.networks.first + position);
    const std::optional<NetworkId> target = Run(network);
    if (!target) return position + 1;
    const uint32_t to = target->index - section.networks.first;
    if (to > position) return to;
    if (jumps == kMostBackwardJumps) {
      Report(Fault::kJumpLoop, network);
      return std::nullopt;
    }
    ++jumps;
    return to;
  }

  void Report(Fault fault, NetworkId id) {
    const Network& network = tree_.networks[id];
    const Section& section = tree_.sections[network.section];
    const uint32_t number = section.kind == SectionKind::kFast   ? static_cast<uint32_t>(-2)
                            : section.kind == SectionKind::kSlow ? static_cast<uint32_t>(-1)
                                                                 : section.number;
    Call("fault", {static_cast<uint64_t>(fault), number, network.number});
  }

  /// 8: only what the program writes of %Q400..499 needs the call; nobody else writes %Q but who tries things out.
  void WatchAlarms(InstructionId id) {
    const Op op = tree_.instructions[id].op;
    const bool coil = op == Op::kOut || op == Op::kOuti || op == Op::kSet || op == Op::kRst;
    if (!coil && op != Op::kWtob) return;
    const Address target = OperandOf(id, coil ? 0 : 1).address;
    const uint32_t count = coil ? 1 : OperandOf(id, 2).bits;
    for (uint32_t number = target.number; target.area == Area::kQ && number < target.number + count; ++number) {
      if (number >= 400 && number < 500) watched_alarms_[number - 400] = true;
    }
  }

  // --- the rung machine (6.1) ---

  struct Rung {
    bool acc = false, live = false;
    std::vector<bool> blocks, branches;

    bool Pop() {
      const bool value = blocks.back();
      blocks.pop_back();
      return value;
    }
  };

  /// The network that a taken jump names.
  std::optional<NetworkId> Run(NetworkId id) {
    const Network& network = tree_.networks[id];
    Rung rung;
    for (uint32_t i = 0; i < network.instructions.count; ++i) {
      const InstructionId at(network.instructions.first + i);
      const Instruction& instruction = tree_.instructions[at];
      if (network.is_drawing) {
        RunElement(at, instruction, rung);
      } else {
        RunInstruction(at, instruction, rung);
      }
      PutBackForced();
      if (instruction.op == Op::kLbl && rung.acc) return OperandOf(at, 0).network;
    }
    return std::nullopt;
  }

  /// An element of a drawing (3.6 rules 6 and 8).
  void RunElement(InstructionId id, const Instruction& instruction, Rung& rung) {
    bool input = instruction.input.kind == InputKind::kRail;
    const Span results = instruction.input.results;
    if (instruction.input.kind == InputKind::kResults) {
      for (uint32_t i = 0; i < results.count; ++i) input |= results_[tree_.results[results.first + i].index];
    }
    rung.acc = input;
    rung.live = true;
    rung.blocks.clear();
    RunInstruction(id, instruction, rung);
    results_[id.index] = rung.acc;
  }

  void RunInstruction(InstructionId id, const Instruction& instruction, Rung& rung) {
    switch (instruction.op) {
      case Op::kLd:
      case Op::kLdi:
      case Op::kLdp:
      case Op::kLdf:
        if (rung.live) rung.blocks.push_back(rung.acc);
        rung.acc = Contact(id, instruction.op);
        rung.live = true;
        return;
      case Op::kAnd:
      case Op::kAndi:
      case Op::kAndp:
      case Op::kAndf: {
        const bool contact = Contact(id, instruction.op);
        rung.acc = rung.acc && contact;
        rung.live = true;
        return;
      }
      case Op::kOr:
      case Op::kOri:
      case Op::kOrp:
      case Op::kOrf: {
        const bool contact = Contact(id, instruction.op);
        rung.acc = rung.acc || contact;
        return;
      }
      case Op::kAnb: {
        const bool other = rung.Pop();
        rung.acc = other && rung.acc;
        return;
      }
      case Op::kOrb: {
        const bool other = rung.Pop();
        rung.acc = other || rung.acc;
        return;
      }
      case Op::kMps:
        rung.branches.push_back(rung.acc);
        rung.live = true;
        return;
      case Op::kMrd:
        rung.acc = rung.branches.back();
        rung.live = true;
        return;
      case Op::kMpp:
        rung.acc = rung.branches.back();
        rung.branches.pop_back();
        rung.live = true;
        return;
      case Op::kRung:
        rung = {};
        return;
      case Op::kRemark:
        return;
      default:
        if (RunWithQ(id, instruction, rung)) {
          rung.live = true;
          return;
        }
        RunOutput(id, instruction, rung.acc);
        rung.live = false;
        return;
    }
  }

  static bool IsEdge(Op op) {
    return op == Op::kLdp || op == Op::kLdf || op == Op::kAndp || op == Op::kAndf || op == Op::kOrp || op == Op::kOrf;
  }

  /// v(a), with the edges of 7.1.
  bool Contact(InstructionId id, Op op) {
    const bool x = Bit(OperandOf(id, 0));
    if (op == Op::kLdi || op == Op::kAndi || op == Op::kOri) return !x;
    if (!IsEdge(op)) return x;
    const bool before = edges_[id.index];
    edges_[id.index] = x;
    const bool falling = op == Op::kLdf || op == Op::kAndf || op == Op::kOrf;
    return falling ? !x && before : x && !before;
  }

  /// Values of the pins, by letter; those without a name come from the stack, the last one is in ACC (3.4).
  std::map<char, bool> Pins(const Instruction& instruction, Rung& rung) {
    std::map<char, bool> values;
    for (uint32_t i = instruction.pins.count; i-- > 0;) {
      const Pin& pin = tree_.pins[instruction.pins.first + i];
      if (pin.from_stack) {
        values[pin.name] = rung.acc;
        rung.acc = rung.Pop();
      } else {
        values[pin.name] = Bit(pin.operand) != pin.operand.inverted;
      }
    }
    return values;
  }

  // --- blocks with Q (6.5, 7); false: it has none ---

  bool RunWithQ(InstructionId id, const Instruction& instruction, Rung& rung) {
    const auto compare = [&](ExprKind relation) {
      rung.acc = rung.acc && Compare(relation, Number(OperandOf(id, 0)), Number(OperandOf(id, 1)));
      return true;
    };
    switch (instruction.op) {
      case Op::kEq:
        return compare(ExprKind::kEqual);
      case Op::kNe:
        return compare(ExprKind::kNotEqual);
      case Op::kGt:
        return compare(ExprKind::kGreater);
      case Op::kGe:
        return compare(ExprKind::kGreaterEqual);
      case Op::kLt:
        return compare(ExprKind::kLess);
      case Op::kLe:
        return compare(ExprKind::kLessEqual);
      case Op::kComp: {
        const Expr& relation = tree_.exprs[OperandOf(id, 0).expr];
        rung.acc = rung.acc && Compare(relation.kind, Evaluate(relation.left), Evaluate(relation.right));
        return true;
      }
      case Op::kCnud: {
        std::map<char, bool> pins = Pins(instruction, rung);
        Counter& counter = counters_[OperandOf(id, 0).address.number];
        counter.Step(rung.acc, pins['P'], pins['M'], pins['N'], Number(OperandOf(id, 1)).whole,
                     tree_.settings.cnud == CnudOption::kHold);
        rung.acc = counter.q;
        PutBackForced();
        return true;
      }
      case Op::kRot:
        RunRot(id, instruction, rung);
        return true;
      case Op::kTon:
      case Op::kTof:
      case Op::kTp:
        rung.acc = RunTimer(id, instruction, rung.acc);
        return true;
      default:
        return false;
    }
  }

  void RunRot(InstructionId id, const Instruction& instruction, Rung& rung) {
    std::map<char, bool> pins = Pins(instruction, rung);
    if (!rung.acc) return;
    const int32_t base = tree_.settings.rotbase == RotBaseOption::kOne ? 1 : 0;
    const auto operand = [&](uint32_t i) { return Number(OperandOf(id, i)).whole; };
    const std::optional<Rotation> rotation = Rotate(operand(0), operand(1), operand(2), base, pins['M']);
    if (!rotation) {
      rung.acc = false;
      Report(Fault::kRotRange, instruction.network);
      return;
    }
    Store(OperandOf(id, 3), {.whole = rotation->result});
    rung.acc = rotation->forward == (tree_.settings.rotq == RotQOption::kForward);
  }

  bool RunTimer(InstructionId id, const Instruction& instruction, bool input) {
    Timer& timer = timers_[OperandOf(id, 0).address.number];
    const int32_t preset = Number(OperandOf(id, 1)).whole;
    const int64_t unit = instruction.unit == TimerUnit::kHundredMs ? 100
                         : instruction.unit == TimerUnit::kSecond  ? 1000
                                                                   : 60'000;
    if (instruction.op == Op::kTon) {
      timer.StepOn(input, preset, unit, period_);
    } else if (instruction.op == Op::kTof) {
      timer.StepOff(input, preset, unit, period_);
    } else if (tree_.settings.tp == TpOption::kIec) {
      timer.StepPulseIec(input, preset, unit, period_);
    } else {
      timer.StepPulseManual(input, preset, unit, period_);
    }
    // A forced Q has its value for whoever reads it from the next instruction on: the block's own output is what it
    // computed.
    const bool q = timer.q;
    PutBackForced();
    return q;
  }

  // --- coils and blocks without Q (6.2 to 6.4, 6.6 to 6.8) ---

  void RunOutput(InstructionId id, const Instruction& instruction, bool acc) {
    const auto coil = [&](bool value) {
      const Address address = OperandOf(id, 0).address;
      image_.SetBit(address.area, address.number, value);
    };
    switch (instruction.op) {
      case Op::kOut:
        coil(acc);
        return;
      case Op::kOuti:
        coil(!acc);
        return;
      case Op::kHome:
      case Op::kPosa:
      case Op::kPosm:
      case Op::kVelp:
      case Op::kVeln:
        RunAxis(id, instruction, acc);
        return;
      default:
        break;
    }
    if (!acc) return;
    switch (instruction.op) {
      case Op::kSet:
        coil(true);
        return;
      case Op::kRst:
        coil(false);
        return;
      case Op::kCall: {
        const auto kept = results_;  // of a drawing; the subroutine has its own
        RunSection(OperandOf(id, 0).section);
        results_ = kept;
        return;
      }
      case Op::kLbl:
        return;
      default:
        RunBlock(id, instruction.op);
        return;
    }
  }

  /// 6.8
  void RunAxis(InstructionId id, const Instruction& instruction, bool acc) {
    AxisState& state = axes_[id.index];
    const Op op = instruction.op;
    const auto kind = static_cast<uint64_t>(op) - static_cast<uint64_t>(Op::kHome);
    const int64_t index =
        int64_t{Number(OperandOf(id, 0)).whole} - (tree_.settings.axisbase == AxisBaseOption::kOne ? 1 : 0);
    const bool valid = acc && index >= 0 && index <= 9;
    if (state.active && (!valid || index != state.axis)) {
      image_.SetBit(Area::kQ, 1000 + state.axis, false);
      state.active = false;
      Call("axis_command", {state.axis, kind, 0, 0, 0, 0});
    }
    if (acc && !valid) Report(Fault::kAxisRange, instruction.network);
    if (!valid) return;
    const auto i = static_cast<uint32_t>(index);
    state.axis = i;
    std::array<uint32_t, 3> wanted{};
    float speed = 0;
    if (op == Op::kHome || op == Op::kPosa || op == Op::kPosm) {
      const Host50Value second = Number(OperandOf(id, 1));
      wanted[op == Op::kHome ? 0 : 1] =
          op == Op::kHome ? static_cast<uint32_t>(second.whole) : std::bit_cast<uint32_t>(second.AsFloat());
      speed = Number(OperandOf(id, 2)).AsFloat();
    } else {
      speed = Number(OperandOf(id, 1)).AsFloat();
    }
    wanted[2] = std::bit_cast<uint32_t>(op == Op::kVeln ? -speed : speed);
    image_.SetBit(Area::kQ, 1000 + i, true);
    image_.SetBit(Area::kQ, 1020 + i, op == Op::kPosa || op == Op::kPosm);
    image_.SetBit(Area::kQ, 1030 + i, op == Op::kPosa);
    image_.SetBit(Area::kQ, 1040 + i, op == Op::kHome);
    if (op == Op::kHome) image_.SetUnit(Area::kQw, i, wanted[0]);
    if (op == Op::kPosa || op == Op::kPosm) image_.SetUnit(Area::kQf, 10 + i, wanted[1]);
    image_.SetUnit(Area::kQf, i, wanted[2]);
    const bool sent_already = SentAlready(wanted[0], state.sent[0], false) &&
                              SentAlready(wanted[1], state.sent[1], true) &&
                              SentAlready(wanted[2], state.sent[2], true);
    if (!state.active || !sent_already) Call("axis_command", {i, kind, 1, wanted[0], wanted[1], wanted[2]});
    state.sent = wanted;
    state.active = true;
  }

  SectionId fast_, slow_;
  std::vector<uint32_t> slices_;        // by position of the network in SLOW
  std::vector<bool> edges_;             // by instruction: m of 7.1
  std::vector<bool> results_;           // by instruction, of drawings
  std::map<uint32_t, AxisState> axes_;  // by instruction
  std::array<bool, 100> alarms_{};      // at the end of the last tick
  std::optional<std::vector<std::vector<uint8_t>>> stored_;
  uint32_t tick_ = 0, period_ = 1;
  uint32_t next_network_ = 0, backward_ = 0;  // SLICED: where SLOW goes on, its jumps in this pass
  bool slow_ended_ = false;
  std::array<bool, 100> watched_alarms_{};
};

}  // namespace

std::unique_ptr<Reference> MakeHost50(dialects::Request& request, HostCalls host) {
  return std::make_unique<Host50>(request, std::move(host));
}

}  // namespace plcxx::reference
