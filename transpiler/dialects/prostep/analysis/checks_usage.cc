// What is set, started or declared, but never used, and the other way round.
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "transpiler/dialects/prostep/analysis/accesses.h"
#include "transpiler/dialects/prostep/analysis/program_checks.h"

namespace plcxx::prostep {
namespace {

/// Bits of F that the program may set: R alone sets nothing.
struct SetFlags {
  std::array<uint8_t, 256> bits{};
  std::array<source::Range, 256 * 8> first_set{};  // by a bit instruction; empty: only as part of a byte or field

  bool IsSet(uint32_t byte, uint32_t bit) const { return (bits[byte] >> bit & 1) != 0; }
};

SetFlags CollectSetFlags(const Program& program) {
  SetFlags flags;
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op == Op::kReset) continue;
    for (const MemoryAccess& access : AccessesOf(program, instruction)) {
      if (access.space != Space::kF) continue;
      for (uint32_t i = 0; i < access.bytes; ++i) {
        if (!MayWrite(access, Space::kF, access.first + i, 0xFF)) continue;
        flags.bits[access.first + i] |= access.bits;
      }
      const bool one_bit = instruction.operand.exists() && instruction.operand.shape() == Shape::kBit;
      if (!one_bit || access.access != Access::kWrite) continue;
      source::Range& first = flags.first_set[access.first * 8 + instruction.operand.bit];
      if (first == source::Range{}) first = access.range;
    }
  }
  return flags;
}

/// Run by the scheduler while its activity bit is 1.
bool IsScheduled(const Module& module) { return module.number > 0 && module.number < kFirstSubroutine; }

std::string FlagName(uint32_t byte, uint32_t bit) { return "F " + std::to_string(byte) + "." + std::to_string(bit); }

/// What the program does with one timer or counter.
struct Use {
  source::Range first_step, first_read;
  bool stepped() const { return first_step != source::Range{}; }
  bool read() const { return first_read != source::Range{}; }
};

void NoteFirst(source::Range& first, source::Range range) {
  if (first == source::Range{}) first = range;
}

/// Which edge memory of its timer or counter a start instruction uses; timers have one, counters two.
enum class Edge : uint8_t { kNone, kTimer, kUp, kDown };

Edge EdgeOf(const Instruction& instruction) {
  if (instruction.op == Op::kCountUp) return Edge::kUp;
  if (instruction.op == Op::kCountDown) return Edge::kDown;
  const InstructionInfo& info = Info(instruction.op);
  return info.lines == Lines::kOwnAndNext && (info.own & kTimerSet) != 0 ? Edge::kTimer : Edge::kNone;
}

/// Does the next instruction that is not neutral use S, which is the output of the timer or counter before it?
bool IsOutputUsed(const Program& program, uint32_t instruction, uint32_t end) {
  for (uint32_t i = instruction + 1; i < end; ++i) {
    const Op op = program.instructions[InstructionId(i)].op;
    switch (Info(op).role) {
      case Role::kNeutral:
        break;
      case Role::kJump:
        return op == Op::kJumpIf;
      case Role::kEnds:
        return op != Op::kTransfer && op != Op::kPerform && op != Op::kEndModule;
      case Role::kLogic:
      case Role::kCompare:
      case Role::kString:
      case Role::kOpen:
      case Role::kClose:
        return false;
    }
  }
  return false;
}

}  // namespace

void CheckLabels(const Program& program, diag::Engine& diagnostics) {
  for (const Label& label : program.labels) {
    if (label.uses == 0) diagnostics.Report(label.range, diag::ProstepLabelUnused, label.name);
  }
}

void CheckActivity(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  if (program.files.empty()) return;
  const source::Offset begin = sources.WholeFile(program.files.front().file).begin;
  const source::Range place = program.modules.empty() ? source::Range{begin, begin} : program.modules.begin()->open;
  if (!program.module_of[0].valid()) diagnostics.Report(place, diag::ProstepNoInitialisation);

  const SetFlags flags = CollectSetFlags(program);
  const bool scheduled = std::ranges::any_of(program.modules, IsScheduled);
  if (scheduled && flags.bits[kActivityByte] == 0 && flags.bits[kActivityByte + 1] == 0) {
    diagnostics.Report(place, diag::ProstepNothingActive);
  }
  for (const Module& module : program.modules) {
    if (!IsScheduled(module)) continue;
    const uint32_t index = module.number - 1u;
    const uint32_t byte = kActivityByte + index / 8;
    if (flags.IsSet(byte, index % 8)) continue;
    diagnostics.Report(module.open, diag::ProstepNeverActive, "PM " + std::to_string(module.number),
                       FlagName(byte, index % 8));
  }
}

void CheckMessages(const Program& program, diag::Engine& diagnostics) {
  const SetFlags flags = CollectSetFlags(program);
  std::array<bool, kMessages + 1> has_text{};
  for (const Text& text : program.messages) {
    has_text[text.number] = true;
    const uint32_t byte = kFirstMessageByte + (text.number - 1u) / 8, bit = (text.number - 1u) % 8;
    if (flags.IsSet(byte, bit)) continue;
    diagnostics.Report(text.range, diag::ProstepTextWithoutMessage, text.number, FlagName(byte, bit));
  }
  for (uint32_t number = 1; number <= kMessages; ++number) {
    const uint32_t byte = kFirstMessageByte + (number - 1) / 8, bit = (number - 1) % 8;
    const source::Range set = flags.first_set[byte * 8 + bit];
    if (has_text[number] || set == source::Range{}) continue;
    diagnostics.Report(set, diag::ProstepMessageWithoutText, number, FlagName(byte, bit));
  }
}

void CheckTimersAndCounters(const Program& program, diag::Engine& diagnostics) {
  std::array<Use, kTimers> timers;
  std::array<Use, kCounters> counters;
  std::map<std::pair<Edge, uint32_t>, std::vector<const Instruction*>> edges;  // by number
  for (const Module& module : program.modules) {
    const uint32_t end = module.end_of().index;
    for (uint32_t i = module.instructions.first; i < end; ++i) {
      const Instruction& instruction = program.instructions[InstructionId(i)];
      const Operand& operand = instruction.operand;
      if (!operand.exists()) continue;
      const bool timer = operand.shape() == Shape::kTimer;
      if (!timer && operand.shape() != Shape::kCounter) continue;
      Use& use = timer ? timers[operand.number] : counters[operand.number];
      const Edge edge = EdgeOf(instruction);
      const Role role = Info(instruction.op).role;
      if (role == Role::kLogic || role == Role::kNeutral) NoteFirst(use.first_read, operand.range);
      if (edge != Edge::kNone || instruction.op == Op::kSetCounter) NoteFirst(use.first_step, instruction.range);
      if (edge == Edge::kNone) continue;
      if (IsOutputUsed(program, i, end)) NoteFirst(use.first_read, operand.range);
      edges[{edge, operand.number}].push_back(&instruction);
    }
  }
  for (const auto& [memory, users] : edges) {
    if (users.size() < 2) continue;
    for (const Instruction* user : users) {
      const Instruction* other = user == users.front() ? users.back() : users.front();
      diagnostics.Report(user->range, diag::ProstepEdgeShared, ToText(user->operand))
          .notes.push_back({other->range, "stepped here, too"});
    }
  }
  const auto report = [&](const auto& uses, std::string_view name) {
    for (uint32_t number = 0; number < uses.size(); ++number) {
      const Use& use = uses[number];
      const std::string text = std::string(name) + " " + std::to_string(number);
      if (use.read() && !use.stepped()) diagnostics.Report(use.first_read, diag::ProstepReadNeverStarted, text);
      if (use.stepped() && !use.read()) diagnostics.Report(use.first_step, diag::ProstepStartedNeverRead, text);
    }
  };
  report(timers, "T");
  report(counters, "C");
}

void CheckInputWrites(const Program& program, diag::Engine& diagnostics) {
  const auto data = InitialData(program);
  const uint32_t declared = data[kInputCountAddress] | uint32_t{data[kInputCountAddress + 1]} << 8;
  for (const Instruction& instruction : program.instructions) {
    for (const MemoryAccess& access : AccessesOf(program, instruction)) {
      if (access.indirect) continue;
      for (uint32_t port = 0; port < std::min(declared, kMostInputBytes); ++port) {
        if (!MayWrite(access, Space::kI, InputByteOfPort(port), 0xFF)) continue;
        const std::string name = "IB " + std::to_string(InputByteOfPort(port));
        diagnostics.Report(access.range, diag::ProstepInputWrite,
                           access.bits == 0xFF ? name : ToText(instruction.operand));
        break;
      }
    }
  }
}

}  // namespace plcxx::prostep
