#include "tests/symbolic/smt_text.h"

#include <vector>

#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::solver {
namespace {

/// A quoted symbol: what SMT-LIB does not allow in one becomes '_'.
std::string Symbol(const std::string& name, uint32_t number) {
  std::string symbol = "|" + std::to_string(number) + " ";
  for (const char c : name) symbol += c == '|' || c == '\\' ? '_' : c;
  return symbol + "|";
}

std::string Sort(uint8_t width) { return "(_ BitVec " + std::to_string(width) + ")"; }

const char* OperationName(terms::TermKind kind) {
  switch (kind) {
    case terms::TermKind::kNot:
      return "bvnot";
    case terms::TermKind::kAnd:
      return "bvand";
    case terms::TermKind::kOr:
      return "bvor";
    case terms::TermKind::kXor:
      return "bvxor";
    case terms::TermKind::kAdd:
      return "bvadd";
    case terms::TermKind::kSub:
      return "bvsub";
    case terms::TermKind::kMul:
      return "bvmul";
    case terms::TermKind::kUdiv:
      return "bvudiv";
    case terms::TermKind::kUrem:
      return "bvurem";
    case terms::TermKind::kSdiv:
      return "bvsdiv";
    case terms::TermKind::kSrem:
      return "bvsrem";
    case terms::TermKind::kShl:
      return "bvshl";
    case terms::TermKind::kLshr:
      return "bvlshr";
    case terms::TermKind::kAshr:
      return "bvashr";
    case terms::TermKind::kConcat:
      return "concat";
    case terms::TermKind::kUlt:
      return "bvult";
    case terms::TermKind::kSlt:
      return "bvslt";
    case terms::TermKind::kEq:
    case terms::TermKind::kIte:
    case terms::TermKind::kConst:
    case terms::TermKind::kVariable:
    case terms::TermKind::kExtract:
    case terms::TermKind::kApply:
      break;
  }
  PLCXX_UNREACHABLE();
}

/// Of a term that is defined by its own line, its name; constants are spelled.
std::string Reference(const terms::Terms& terms, terms::TermId id) {
  if (terms.IsConst(id)) {
    return "(_ bv" + std::to_string(terms.Value(id)) + " " + std::to_string(terms.Width(id)) + ")";
  }
  const terms::Term& term = terms[id];
  if (term.kind == terms::TermKind::kVariable) return Symbol(terms.VariableName(term.a), term.a);
  return "t" + std::to_string(id.index);
}

std::string Definition(const terms::Terms& terms, const terms::Term& term) {
  const auto reference = [&terms](uint32_t id) { return Reference(terms, terms::TermId(id)); };
  const auto as_bit = [](const std::string& condition) { return "(ite " + condition + " (_ bv1 1) (_ bv0 1))"; };
  switch (term.kind) {
    case terms::TermKind::kNot:
      return "(bvnot " + reference(term.a) + ")";
    case terms::TermKind::kIte:
      return "(ite (= " + reference(term.a) + " (_ bv1 1)) " + reference(term.b) + " " + reference(term.c) + ")";
    case terms::TermKind::kExtract:
      return "((_ extract " + std::to_string(term.b + term.width - 1) + " " + std::to_string(term.b) + ") " +
             reference(term.a) + ")";
    case terms::TermKind::kApply: {
      std::string text = "(" + Symbol(terms.Info(terms::FunctionId(term.a)).name, term.a);
      for (const terms::TermId argument : terms.Arguments(term)) text += " " + Reference(terms, argument);
      return text + ")";
    }
    case terms::TermKind::kEq:
      return as_bit("(= " + reference(term.a) + " " + reference(term.b) + ")");
    case terms::TermKind::kUlt:
    case terms::TermKind::kSlt:
      return as_bit("(" + std::string(OperationName(term.kind)) + " " + reference(term.a) + " " + reference(term.b) +
                    ")");
    case terms::TermKind::kAnd:
    case terms::TermKind::kOr:
    case terms::TermKind::kXor:
    case terms::TermKind::kAdd:
    case terms::TermKind::kSub:
    case terms::TermKind::kMul:
    case terms::TermKind::kUdiv:
    case terms::TermKind::kUrem:
    case terms::TermKind::kSdiv:
    case terms::TermKind::kSrem:
    case terms::TermKind::kShl:
    case terms::TermKind::kLshr:
    case terms::TermKind::kAshr:
    case terms::TermKind::kConcat:
      return "(" + std::string(OperationName(term.kind)) + " " + reference(term.a) + " " + reference(term.b) + ")";
    case terms::TermKind::kConst:
    case terms::TermKind::kVariable:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

std::string SmtText(const terms::Terms& terms, std::span<const terms::TermId> conditions) {
  std::string text = "(set-logic QF_UFBV)\n";
  std::vector<bool> declared(terms.function_count());
  for (const terms::TermId id : terms::ConeOf(terms, conditions)) {
    const terms::Term& term = terms[id];
    if (term.kind == terms::TermKind::kConst) continue;
    if (term.kind == terms::TermKind::kVariable) {
      text += "(declare-const " + Symbol(terms.VariableName(term.a), term.a) + " " + Sort(term.width) + ")\n";
      continue;
    }
    // Functions are told apart by their numbers of arguments, too; one name always has one.
    if (term.kind == terms::TermKind::kApply && !declared[term.a]) {
      declared[term.a] = true;
      text += "(declare-fun " + Symbol(terms.Info(terms::FunctionId(term.a)).name, term.a) + " (";
      std::string separator;
      for (const terms::TermId argument : terms.Arguments(term)) {
        text += separator + Sort(terms.Width(argument));
        separator = " ";
      }
      text += ") " + Sort(term.width) + ")\n";
    }
    text +=
        "(define-fun t" + std::to_string(id.index) + " () " + Sort(term.width) + " " + Definition(terms, term) + ")\n";
  }
  for (const terms::TermId condition : conditions) {
    text += "(assert (= " + Reference(terms, condition) + " (_ bv1 1)))\n";
  }
  return text + "(check-sat)\n";
}

}  // namespace plcxx::solver
