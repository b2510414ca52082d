#include <vector>

#include "transpiler/prove/solver/solver.h"
#include "transpiler/prove/terms/cone.h"

namespace plcxx::prove {
namespace {

/// A quoted symbol: what SMT-LIB does not allow in one becomes '_'.
std::string Symbol(const std::string& name, uint32_t number) {
  std::string symbol = "|" + std::to_string(number) + " ";
  for (const char c : name) symbol += c == '|' || c == '\\' ? '_' : c;
  return symbol + "|";
}

std::string Sort(uint8_t width) { return "(_ BitVec " + std::to_string(width) + ")"; }

const char* OperationName(TermKind kind) {
  switch (kind) {
    case TermKind::kNot:
      return "bvnot";
    case TermKind::kAnd:
      return "bvand";
    case TermKind::kOr:
      return "bvor";
    case TermKind::kXor:
      return "bvxor";
    case TermKind::kAdd:
      return "bvadd";
    case TermKind::kSub:
      return "bvsub";
    case TermKind::kMul:
      return "bvmul";
    case TermKind::kUdiv:
      return "bvudiv";
    case TermKind::kUrem:
      return "bvurem";
    case TermKind::kSdiv:
      return "bvsdiv";
    case TermKind::kSrem:
      return "bvsrem";
    case TermKind::kShl:
      return "bvshl";
    case TermKind::kLshr:
      return "bvlshr";
    case TermKind::kAshr:
      return "bvashr";
    case TermKind::kConcat:
      return "concat";
    case TermKind::kUlt:
      return "bvult";
    case TermKind::kSlt:
      return "bvslt";
    case TermKind::kEq:
    case TermKind::kIte:
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kExtract:
    case TermKind::kApply:
      break;
  }
  PLCXX_UNREACHABLE();
}

/// Of a term that is defined by its own line, its name; constants are spelled.
std::string Reference(const Terms& terms, TermId id) {
  if (terms.IsConst(id)) {
    return "(_ bv" + std::to_string(terms.Value(id)) + " " + std::to_string(terms.Width(id)) + ")";
  }
  const Term& term = terms[id];
  if (term.kind == TermKind::kVariable) return Symbol(terms.VariableName(term.a), term.a);
  return "t" + std::to_string(id.index);
}

std::string Definition(const Terms& terms, const Term& term) {
  const auto reference = [&terms](uint32_t id) { return Reference(terms, TermId(id)); };
  const auto as_bit = [](const std::string& condition) { return "(ite " + condition + " (_ bv1 1) (_ bv0 1))"; };
  switch (term.kind) {
    case TermKind::kNot:
      return "(bvnot " + reference(term.a) + ")";
    case TermKind::kIte:
      return "(ite (= " + reference(term.a) + " (_ bv1 1)) " + reference(term.b) + " " + reference(term.c) + ")";
    case TermKind::kExtract:
      return "((_ extract " + std::to_string(term.b + term.width - 1) + " " + std::to_string(term.b) + ") " +
             reference(term.a) + ")";
    case TermKind::kApply: {
      std::string text = "(" + Symbol(terms.Info(FunctionId(term.a)).name, term.a);
      for (const TermId argument : terms.Arguments(term)) text += " " + Reference(terms, argument);
      return text + ")";
    }
    case TermKind::kEq:
      return as_bit("(= " + reference(term.a) + " " + reference(term.b) + ")");
    case TermKind::kUlt:
    case TermKind::kSlt:
      return as_bit("(" + std::string(OperationName(term.kind)) + " " + reference(term.a) + " " + reference(term.b) +
                    ")");
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
    case TermKind::kConcat:
      return "(" + std::string(OperationName(term.kind)) + " " + reference(term.a) + " " + reference(term.b) + ")";
    case TermKind::kConst:
    case TermKind::kVariable:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

std::string SmtText(const Terms& terms, std::span<const TermId> conditions) {
  std::string text = "(set-logic QF_UFBV)\n";
  std::vector<bool> declared(terms.function_count());
  for (const TermId id : ConeOf(terms, conditions)) {
    const Term& term = terms[id];
    if (term.kind == TermKind::kConst) continue;
    if (term.kind == TermKind::kVariable) {
      text += "(declare-const " + Symbol(terms.VariableName(term.a), term.a) + " " + Sort(term.width) + ")\n";
      continue;
    }
    // Functions are told apart by their numbers of arguments, too; one name always has one.
    if (term.kind == TermKind::kApply && !declared[term.a]) {
      declared[term.a] = true;
      text += "(declare-fun " + Symbol(terms.Info(FunctionId(term.a)).name, term.a) + " (";
      std::string separator;
      for (const TermId argument : terms.Arguments(term)) {
        text += separator + Sort(terms.Width(argument));
        separator = " ";
      }
      text += ") " + Sort(term.width) + ")\n";
    }
    text +=
        "(define-fun t" + std::to_string(id.index) + " () " + Sort(term.width) + " " + Definition(terms, term) + ")\n";
  }
  for (const TermId condition : conditions) {
    text += "(assert (= " + Reference(terms, condition) + " (_ bv1 1)))\n";
  }
  return text + "(check-sat)\n";
}

}  // namespace plcxx::prove
