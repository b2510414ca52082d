// The names in Documentation::symbols, one by one and without a copy: who looks for one asks every row of a program.
#pragma once

#include <algorithm>
#include <string_view>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// Whether one of the names, in their order, is what `is_it` looks for; later ones are not asked about.
template <class Predicate>
bool AnySymbolName(const Documentation& known, Predicate&& is_it) {
  constexpr std::string_view kBetween = ", ";
  for (std::string_view rest = known.symbols; !rest.empty();) {
    const size_t end = std::min(rest.find(kBetween), rest.size());
    if (is_it(rest.substr(0, end))) return true;
    rest.remove_prefix(std::min(end + kBetween.size(), rest.size()));
  }
  return false;
}

template <class Visit>
void ForEachSymbolName(const Documentation& known, Visit&& visit) {
  AnySymbolName(known, [&visit](std::string_view name) {
    visit(name);
    return false;
  });
}

}  // namespace plcxx::ir
