// Forms of terms: equal after a renaming of variables and unknown functions, and after nothing else.
#include "transpiler/prove/terms/form.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {
namespace {

TermId Of(Terms& terms, const char* function, TermId argument) {
  return terms.Apply(terms.Function(function, 8), std::array{argument});
}

TEST(Form, NamesDoNotMatter) {
  Terms terms;
  const TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8), u = terms.Variable("u", 8),
               v = terms.Variable("v", 8);
  EXPECT_EQ(FormOf(terms, terms.Sub(x, y)), FormOf(terms, terms.Sub(u, v)));
  EXPECT_EQ(FormOf(terms, terms.Sub(x, y)), FormOf(terms, terms.Sub(y, x)));
  EXPECT_EQ(FormOf(terms, Of(terms, "f", x)), FormOf(terms, Of(terms, "g", y)));
}

/// Each of these has a form of its own.
TEST(Form, AllElseMatters) {
  Terms terms;
  const TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8), narrow = terms.Variable("narrow", 4);
  const auto value = +[](std::span<const uint64_t> arguments) { return arguments[0] ^ 1; };
  const auto known = [&](const char* name) { return terms.Apply(terms.Function(name, 8, value), std::array{x}); };
  const std::vector<TermId> all = {
      x,
      narrow,
      terms.Const(1, 8),
      terms.Const(2, 8),
      terms.Const(1, 4),
      terms.Sub(x, y),
      terms.Add(x, y),
      terms.Add(x, x),
      terms.Add(x, terms.Const(1, 8)),
      terms.Add(x, terms.Const(2, 8)),
      terms.Extract(x, 0, 4),
      terms.Extract(x, 1, 4),
      terms.Extract(x, 1, 5),
      terms.Concat(narrow, narrow),
      terms.Ite(terms.Ult(x, y), x, y),
      terms.Ite(terms.Ult(x, y), y, x),
      Of(terms, "f", x),
      Of(terms, "f", terms.Const(1, 8)),
      terms.Sub(Of(terms, "f", x), Of(terms, "f", y)),
      terms.Sub(Of(terms, "f", x), Of(terms, "g", y)),
      terms.Sub(Of(terms, "f", x), Of(terms, "g", x)),
      terms.Sub(Of(terms, "f", x), y),
      known("even"),
      known("odd"),
  };
  std::set<std::string> forms;
  for (const TermId term : all) EXPECT_TRUE(forms.insert(FormOf(terms, term)).second) << "term " << term.index;
}

}  // namespace
}  // namespace plcxx::prove
