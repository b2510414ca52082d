// Functions of C's library that give a number for numbers (as their manuals say it, apart from the IR's operations).
#include <algorithm>

#include "transpiler/prove/verify/front_end/front_end.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::prove::verify::front_end {
namespace {

terms::TermId Magnitude(terms::Terms& terms, terms::TermId a) {
  const uint8_t width = terms.Width(a);
  return terms.Ite(terms.Slt(a, terms.Const(0, width)), terms.Neg(a), a);
}

/// The count modulo the width, so that a rotation by -1 is one by the width less 1.
terms::TermId Rotated(terms::Terms& terms, terms::TermId a, terms::TermId count, bool left) {
  const uint8_t width = terms.Width(a);
  const auto bits = static_cast<uint8_t>(width == 32 ? 5 : 4);
  const terms::TermId by = terms.Zext(terms.Extract(count, 0, bits), width);
  const terms::TermId rest = terms.Sub(terms.Const(width, width), by);
  return left ? terms.Or(terms.Shl(a, by), terms.Lshr(a, rest)) : terms.Or(terms.Lshr(a, by), terms.Shl(a, rest));
}

}  // namespace

terms::TermId LibraryResult(terms::Terms& terms, std::string_view name, std::span<const terms::TermId> arguments) {
  using Arguments = std::span<const terms::TermId>;
  struct Row {
    std::string_view name;
    size_t arguments;
    terms::TermId (*result)(terms::Terms& terms, Arguments arguments);
  };
  constexpr auto kMagnitude = [](terms::Terms& t, Arguments a) { return Magnitude(t, a[0]); };
  constexpr auto kLeft = [](terms::Terms& t, Arguments a) { return Rotated(t, a[0], a[1], true); };
  constexpr auto kRight = [](terms::Terms& t, Arguments a) { return Rotated(t, a[0], a[1], false); };
  static constexpr Row kRows[] = {
      {"abs", 1, kMagnitude},
      {"?abs@@$$J0YAHH@Z", 1, kMagnitude},  // of two, one for each type
      {"?abs@@$$J0YAJJ@Z", 1, kMagnitude},
      {"labs", 1, kMagnitude},
      {"_rotl", 2, kLeft},
      {"_rotr", 2, kRight},
      {"_lrotl", 2, kLeft},
      {"_lrotr", 2, kRight},
      {"fabs", 1, [](terms::Terms& t, Arguments a) { return terms::FloatAbs(t, a[0]); }},
      {"floor", 1, [](terms::Terms& t, Arguments a) { return terms::FloatFloor(t, a[0]); }},
      {"ceil", 1, [](terms::Terms& t, Arguments a) { return terms::FloatCeil(t, a[0]); }},
      {"sqrt", 1, [](terms::Terms& t, Arguments a) { return terms::FloatSqrt(t, a[0]); }},
  };
  const auto* const row = std::ranges::find(kRows, name, &Row::name);
  if (row == std::end(kRows) || row->arguments != arguments.size()) return {};
  return row->result(terms, arguments);
}

}  // namespace plcxx::prove::verify::front_end
