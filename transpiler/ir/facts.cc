#include "transpiler/ir/facts.h"

#include <array>
#include <string>
#include <vector>

namespace plcxx::ir {
namespace {

constexpr std::string_view kFalseFact = "false_fact";
constexpr std::array<std::string_view, 9> kNames = {"COMPARISON", "DIVISION", "SHIFT",    "SIGN",  "VARIABLE",
                                                    "INDEX",      "LOOP",     "REGISTER", "RESULT"};
static_assert(kNames.size() == static_cast<size_t>(FactKind::kResult) + 1);

ValueId AsNumber(Builder& builder, ValueId value) {
  switch (builder.program()[value].type) {
    case Type::kBit:
      return builder.Pure(OpKind::kWiden1To32, {value});
    case Type::kI8:
      return builder.Pure(OpKind::kWiden8To32, {value});
    case Type::kI16:
      return builder.Pure(OpKind::kWiden16To32, {value});
    case Type::kI32:
      return value;
    case Type::kNone:
    case Type::kI64:
    case Type::kF32:
    case Type::kF64:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

std::span<const std::string_view> FactNames() { return kNames; }

HostFunctionId FalseFactOf(const Program& program) {
  for (uint32_t i = 0; i < program.host_functions.size(); ++i) {
    if (program.host_functions[HostFunctionId(i)].name == kFalseFact) return HostFunctionId(i);
  }
  return {};
}

HostFunctionId AddFalseFact(Program& program) {
  HostFunction function{.name = std::string(kFalseFact),
                        .result = Type::kNone,
                        .out = {},
                        .comment = "A fact that a decision rests on does not hold: a fault of the transpiler."};
  function.parameters = {
      {.name = "kind", .type = Type::kI8, .enumerators = {kNames.begin(), kNames.end()}},
      {.name = "statement", .type = Type::kI32, .enumerators = {}, .is_statement = true},
      {.name = "value", .type = Type::kI32, .enumerators = {}},
  };
  return program.host_functions.Add(std::move(function));
}

bool IsFalseFact(const Program& program, const Inst& inst) {
  return inst.op == OpKind::kHostCall &&
         program.host_functions[program.calls[CallId(inst.payload)].host].name == kFalseFact;
}

void FactChecks::Check(FactKind kind, ValueId holds, ValueId value) const {
  if (!on()) return;
  const ValueId wrong = builder_.Pure(OpKind::kBitNot, {holds});
  const RegionId outer = builder_.region(), then = builder_.NewRegion();
  builder_.If(wrong, then);
  builder_.SetRegion(then);
  Fail(kind, value);
  builder_.SetRegion(outer);
}

void FactChecks::Fail(FactKind kind, ValueId value) const {
  if (!on()) return;
  const ValueId number = AsNumber(builder_, value);
  const ValueId which = builder_.Constant(Type::kI8, static_cast<uint64_t>(kind));
  const ValueId statement = builder_.Constant(Type::kI32, 0);  // known later
  builder_.CallHost(false_fact_, {which, statement, number});
}

}  // namespace plcxx::ir
