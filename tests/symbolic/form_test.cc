// Forms of terms: equal after a renaming of variables and unknown functions, and after nothing else.
#include "transpiler/symbolic/terms/form.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove {
namespace {

terms::TermId Of(terms::Terms& terms, const char* function, terms::TermId argument) {
  return terms.Apply(terms.Function(function, 8), std::array{argument});
}

std::string Form(const terms::Terms& terms, terms::TermId term) {
  return terms::FormOf(terms, term, 100).value_or("too large");
}

TEST(Form, NamesDoNotMatter) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8), u = terms.Variable("u", 8),
                      v = terms.Variable("v", 8);
  EXPECT_EQ(Form(terms, terms.Sub(x, y)), Form(terms, terms.Sub(u, v)));
  EXPECT_EQ(Form(terms, terms.Sub(x, y)), Form(terms, terms.Sub(y, x)));
  EXPECT_EQ(Form(terms, Of(terms, "f", x)), Form(terms, Of(terms, "g", y)));
}

/// Each of these has a form of its own.
TEST(Form, AllElseMatters) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8), narrow = terms.Variable("narrow", 4);
  const auto value = +[](std::span<const uint64_t> arguments) { return arguments[0] ^ 1; };
  const auto known = [&](const char* name) { return terms.Apply(terms.Function(name, 8, value), std::array{x}); };
  const std::vector<terms::TermId> all = {
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
  for (const terms::TermId term : all) EXPECT_TRUE(forms.insert(Form(terms, term)).second) << "term " << term.index;
}

/// A function that can be computed is known by its name, whichever number it has.
TEST(Form, TermsOfTwoTables) {
  const auto value = +[](std::span<const uint64_t> arguments) { return arguments[0] ^ 1; };
  terms::Terms one, other;
  other.Function("another", 8, value);
  const auto form = [&](terms::Terms& terms, const char* name) {
    return Form(terms, terms.Apply(terms.Function(name, 8, value), std::array{terms.Variable("x", 8)}));
  };
  EXPECT_EQ(form(one, "even"), form(other, "even"));
  EXPECT_NE(form(one, "even"), form(other, "another"));
  EXPECT_NE(form(one, "odd"), form(other, "even"));
}

TEST(Form, LargeTermsHaveNone) {
  terms::Terms terms;
  const terms::TermId sum = terms.Sub(terms.Variable("x", 8), terms.Variable("y", 8));
  EXPECT_TRUE(terms::FormOf(terms, sum, 3).has_value());
  EXPECT_FALSE(terms::FormOf(terms, sum, 2).has_value());
}

}  // namespace
}  // namespace plcxx::prove
