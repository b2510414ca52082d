// The last look at a function's text: each effect of its instructions was spelled there exactly once.

#include <algorithm>

#include "transpiler/emit/print/cpp_printer.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::print {
Text& Text::operator+=(const Text& more) {
  chars += more.chars;
  effects.insert(effects.end(), more.effects.begin(), more.effects.end());
  return *this;
}

Text Spelled(Text text, ir::InstId effect) {
  text.effects.push_back(effect);
  return text;
}

void SpelledEffects::CheckOnce(const Emittable& emittable, const std::vector<Piece>& function) {
  std::vector<ir::InstId> needed;
  VisitFunction(emittable, function,
                {.inst =
                     [&](ir::InstId id) {
                       if (IsEffect(emittable, id) && !emittable.changes_nothing[id.index]) needed.push_back(id);
                     },
                 .chunk = [](uint32_t) {}});
  const auto by_number = [](ir::InstId left, ir::InstId right) { return left.index < right.index; };
  std::ranges::sort(needed, by_number);
  std::ranges::sort(spelled_, by_number);
  const bool each_effect_is_spelled_once = spelled_ == needed;
  PLCXX_CHECK(each_effect_is_spelled_once);
}

}  // namespace plcxx::emit::print
