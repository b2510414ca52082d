// Values of terms for concrete values of their variables.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// The value of one term whose operands have values; `value(TermId)` gives those, and `variable(number)` a variable's.
template <class Value, class Variable>
uint64_t EvaluateTerm(const Terms& terms, const Term& term, Value&& value, Variable&& variable);

/// By TermId: the value of every term up to `last` for the variables' values (by number; missing ones are 0).
std::vector<uint64_t> EvaluateAll(const Terms& terms, std::span<const uint64_t> variables, TermId last);
/// Of one term; costs as much as EvaluateAll.
uint64_t Evaluate(const Terms& terms, TermId term, std::span<const uint64_t> variables);

/// The made-up value of an unknown function: the same for the same name and arguments, else any.
uint64_t MadeUpValue(const TermFunction& function, std::span<const uint64_t> arguments);

template <class Value, class Variable>
uint64_t EvaluateTerm(const Terms& terms, const Term& term, Value&& value, Variable&& variable) {
  switch (term.kind) {
    case TermKind::kConst:
      return (uint64_t{term.b} << 32) | term.a;
    case TermKind::kVariable:
      return Masked(variable(term.a), term.width);
    case TermKind::kNot:
      return Masked(~value(TermId(term.a)), term.width);
    case TermKind::kIte:
      return value(TermId(term.a)) != 0 ? value(TermId(term.b)) : value(TermId(term.c));
    case TermKind::kConcat:
      return (value(TermId(term.a)) << terms.Width(TermId(term.b))) | value(TermId(term.b));
    case TermKind::kExtract:
      return Masked(value(TermId(term.a)) >> term.b, term.width);
    case TermKind::kApply: {
      std::vector<uint64_t> arguments;
      for (const TermId argument : terms.Arguments(term)) arguments.push_back(value(argument));
      const TermFunction& function = terms.Info(FunctionId(term.a));
      return Masked(function.evaluate != nullptr ? function.evaluate(arguments) : MadeUpValue(function, arguments),
                    term.width);
    }
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
      break;
  }
  return EvaluateBinary(term.kind, value(TermId(term.a)), value(TermId(term.b)), terms.Width(TermId(term.a)));
}

}  // namespace plcxx::terms
