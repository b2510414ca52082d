#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::terms {

uint64_t EvaluateBinary(TermKind kind, uint64_t a, uint64_t b, uint8_t width) {
  const int64_t signed_a = AsSigned(a, width), signed_b = AsSigned(b, width);
  switch (kind) {
    case TermKind::kAnd:
      return a & b;
    case TermKind::kOr:
      return a | b;
    case TermKind::kXor:
      return a ^ b;
    case TermKind::kAdd:
      return Masked(a + b, width);
    case TermKind::kSub:
      return Masked(a - b, width);
    case TermKind::kMul:
      return Masked(a * b, width);
    case TermKind::kUdiv:
      return b == 0 ? Masked(~uint64_t{0}, width) : a / b;
    case TermKind::kUrem:
      return b == 0 ? a : a % b;
    case TermKind::kSdiv:
      if (b == 0) return signed_a < 0 ? 1 : Masked(~uint64_t{0}, width);
      // The least value by -1 is itself; the processor would trap at 64 bits.
      if (signed_b == -1) return Masked(uint64_t{0} - a, width);
      return Masked(static_cast<uint64_t>(signed_a / signed_b), width);
    case TermKind::kSrem:
      if (b == 0) return a;
      if (signed_b == -1) return 0;
      return Masked(static_cast<uint64_t>(signed_a % signed_b), width);
    case TermKind::kShl:
      return b >= width ? 0 : Masked(a << b, width);
    case TermKind::kLshr:
      return b >= width ? 0 : a >> b;
    case TermKind::kAshr:
      return Masked(static_cast<uint64_t>(signed_a >> (b >= width ? 63 : b)), width);
    case TermKind::kEq:
      return a == b ? 1 : 0;
    case TermKind::kUlt:
      return a < b ? 1 : 0;
    case TermKind::kSlt:
      return signed_a < signed_b ? 1 : 0;
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kNot:
    case TermKind::kIte:
    case TermKind::kConcat:
    case TermKind::kExtract:
    case TermKind::kApply:
      break;
  }
  PLCXX_UNREACHABLE();
}

uint64_t MadeUpValue(const TermFunction& function, std::span<const uint64_t> arguments) {
  uint64_t hash = 0xCBF29CE484222325;
  const auto mix = [&hash](uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15;
    hash ^= hash >> 29;
  };
  for (const char c : function.name) mix(static_cast<unsigned char>(c));
  for (const uint64_t argument : arguments) mix(argument);
  return hash;
}

std::vector<uint64_t> EvaluateAll(const Terms& terms, std::span<const uint64_t> variables, TermId last) {
  std::vector<uint64_t> values(last.index + 1);
  for (uint32_t i = 0; i <= last.index; ++i) {
    values[i] = EvaluateTerm(
        terms, terms[TermId(i)], [&values](TermId id) { return values[id.index]; },
        [variables](uint32_t number) { return number < variables.size() ? variables[number] : 0; });
  }
  return values;
}

uint64_t Evaluate(const Terms& terms, TermId term, std::span<const uint64_t> variables) {
  return EvaluateAll(terms, variables, term)[term.index];
}

}  // namespace plcxx::terms
