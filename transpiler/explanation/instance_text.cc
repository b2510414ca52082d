#include "transpiler/explanation/instance_text.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "transpiler/ir/op.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::explanation {
namespace {

/// Milliseconds in one unit of the preset of an instruction that steps a timer; 0: its preset is no time.
uint32_t MsPerPreset(ir::OpKind op) {
  constexpr uint32_t kTenth = 100, kSecond = 1000, kMinute = 60'000;
  using enum ir::OpKind;
  for (const ir::OpKind one : {kTonMs, kTofMs, kTpMs, kPulseMs}) {
    if (op == one) return kTenth;
  }
  for (const ir::OpKind one : {kTonS, kTofS, kTpS, kPulseS}) {
    if (op == one) return kSecond;
  }
  for (const ir::OpKind one : {kTonM, kTofM, kTpM, kPulseM}) {
    if (op == one) return kMinute;
  }
  return op == kOnDelay ? 1 : 0;
}

/// The instruction that steps a timer with a preset; none: there is no such one.
const ir::Inst* StepOf(const ir::Program& program, ir::StateId state) {
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    const ir::Inst& inst = program[ir::InstId(i)];
    if (ir::Info(inst.op).shape == ir::Shape::kStep && inst.payload == state.index && MsPerPreset(inst.op) != 0) {
      return &inst;
    }
  }
  return nullptr;
}

std::string OfTime(uint64_t elapsed_ms, uint64_t preset_ms) {
  const uint64_t left = preset_ms - std::min(elapsed_ms, preset_ms);
  return std::to_string(std::min(elapsed_ms, preset_ms)) + " of " + std::to_string(preset_ms) + " ms, " +
         std::to_string(left) + " ms left";
}

/// The preset as the last step had it; none: it is computed.
std::optional<uint64_t> PresetMs(const ir::Program& program, ir::StateId state, const sim::Instances& instances) {
  const ir::Inst* step = StepOf(program, state);
  if (step == nullptr) return std::nullopt;
  const uint64_t unit = MsPerPreset(step->op);
  if (program.states[state].kind == ir::StateKind::kUnitTimer) {
    return unit * instances.Read(state.index, ir::FieldIndex(ir::StateKind::kUnitTimer, "preset"));
  }
  const ir::Inst& preset = program[ir::ValueId(step->b)];
  if (preset.op != ir::OpKind::kConst) return std::nullopt;
  return unit * ir::ConstantValue(preset);
}

bool IsShown(const ir::FieldInfo& field) { return !field.hidden && field.count == 1; }

std::string FieldsText(ir::StateKind kind, uint32_t instance, const sim::Instances& instances, bool with_names) {
  std::string text;
  const auto fields = ir::Info(kind).fields;
  const auto count = static_cast<uint8_t>(fields.size());
  for (uint8_t field = 0; field < count; ++field) {
    if (!IsShown(fields[field])) continue;
    text += (text.empty() ? "" : ", ") + (with_names ? std::string(fields[field].name) + " " : "") +
            FieldDigits(kind, fields[field].type, instances.Read(instance, field));
  }
  return text;
}

}  // namespace

std::string InstanceText(const ir::Program& program, ir::StateId state, const sim::Instances& instances) {
  const ir::StateKind kind = program.states[state].kind;
  const auto read = [&](std::string_view field) { return instances.Read(state.index, ir::FieldIndex(kind, field)); };
  if (kind == ir::StateKind::kTimeWordTimer) {
    return read("running") != 0 ? std::to_string(read("left_ms")) + " ms left" : "not running";
  }
  if (IsTimer(kind)) {
    const uint64_t elapsed = read("elapsed_ms");
    const std::optional<uint64_t> preset = PresetMs(program, state, instances);
    return preset ? OfTime(elapsed, *preset) : std::to_string(elapsed) + " ms elapsed";
  }
  return FieldsText(kind, state.index, instances, true);
}

std::string InstancePredicate(const ir::Program& program, ir::StateId state, const sim::Instances& instances) {
  const ir::StateKind kind = program.states[state].kind;
  const std::string text = InstanceText(program, state, instances);
  if (kind == ir::StateKind::kTimeWordTimer) {
    const bool running = instances.Read(state.index, ir::FieldIndex(kind, "running")) != 0;
    return (running ? "has " : "is ") + text;
  }
  if (IsTimer(kind)) {
    const bool has_preset = PresetMs(program, state, instances).has_value();
    return "has run " + (has_preset
                             ? text
                             : std::to_string(instances.Read(state.index, ir::FieldIndex(kind, "elapsed_ms"))) + " ms");
  }
  if (text.empty()) return "is as the scan before left it";
  // Of one field alone the name says nothing: what an edge has kept is called "was".
  return "had " + FieldsText(kind, state.index, instances, !HasOneField(kind));
}

std::string FieldDigits(ir::StateKind kind, ir::Type type, uint64_t value) {
  const bool has_sign = kind == ir::StateKind::kPositionCounter && type == ir::Type::kI32;
  return sim::ValueDigits(type, value, has_sign ? sim::Sign::kTwosComplement : sim::Sign::kNone);
}

bool IsTimer(ir::StateKind kind) {
  return kind == ir::StateKind::kTimeWordTimer || kind == ir::StateKind::kOnDelayTimer ||
         kind == ir::StateKind::kUnitTimer;
}

bool HasOneField(ir::StateKind kind) { return std::ranges::count_if(ir::Info(kind).fields, IsShown) == 1; }

}  // namespace plcxx::explanation
