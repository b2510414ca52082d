#include "transpiler/symbolic/terms/form.h"

#include <array>
#include <cstring>
#include <unordered_map>
#include <vector>

namespace plcxx::terms {

/// All that the root is made of, operands first, as kind, width, what the kind needs, and its operands by their place
/// in this row. A function with a meaning is its name. A variable says no more than its place, where it is met first,
/// nor does a function without meaning.
std::optional<std::string> FormOf(const Terms& terms, TermId root, size_t most_terms) {
  std::string form;
  const auto write = [&form](uint32_t number) {
    std::array<char, sizeof number> bytes{};
    std::memcpy(bytes.data(), &number, sizeof number);
    form.append(bytes.data(), bytes.size());
  };
  constexpr uint32_t kUnknown = 0x8000'0000;
  std::unordered_map<uint32_t, uint32_t> places, functions;  // looked up only
  std::vector<TermId> open = {root}, missing;
  while (!open.empty()) {
    const TermId id = open.back();
    if (places.contains(id.index)) {
      open.pop_back();
      continue;
    }
    const Term& term = terms[id];
    missing.clear();
    terms.ForEachOperand(term, [&](TermId operand) {
      if (!places.contains(operand.index)) missing.push_back(operand);
    });
    if (!missing.empty()) {
      open.insert(open.end(), missing.rbegin(), missing.rend());
      continue;
    }
    open.pop_back();
    if (places.size() == most_terms) return std::nullopt;
    places.emplace(id.index, static_cast<uint32_t>(places.size()));
    write(static_cast<uint32_t>(term.kind) << 8 | term.width);
    switch (term.kind) {
      case TermKind::kConst:
        write(term.a);
        write(term.b);
        break;
      case TermKind::kExtract:
        write(term.b);
        break;
      case TermKind::kApply:
        if (const TermFunction& function = terms.Info(FunctionId(term.a)); function.evaluate != nullptr) {
          write(static_cast<uint32_t>(function.name.size()));
          form += function.name;
        } else {
          write(kUnknown | functions.try_emplace(term.a, static_cast<uint32_t>(functions.size())).first->second);
        }
        write(term.c);
        break;
      case TermKind::kVariable:
      case TermKind::kNot:
      case TermKind::kAnd:
      case TermKind::kOr:
      case TermKind::kXor:
      case TermKind::kAdd:
      case TermKind::kSub:
      case TermKind::kMul:
      case TermKind::kUdiv:
      case TermKind::kUrem:
      case TermKind::kSdiv:
      case TermKind::kSrem:
      case TermKind::kShl:
      case TermKind::kLshr:
      case TermKind::kAshr:
      case TermKind::kEq:
      case TermKind::kUlt:
      case TermKind::kSlt:
      case TermKind::kIte:
      case TermKind::kConcat:
        break;
    }
    terms.ForEachOperand(term, [&](TermId operand) { write(places.at(operand.index)); });
  }
  return form;
}

}  // namespace plcxx::terms
