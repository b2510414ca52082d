#include "tests/mutants/mutate/edits.h"

namespace plcxx::mutants {

void Edits::Wrap(unsigned begin, unsigned end, const std::string& before, const std::string& after) {
  places_[begin].opening += before;
  std::string& closing = places_[end].closing;
  closing.insert(0, after);
}

void Edits::Replace(unsigned begin, unsigned end, const std::string& text) {
  Place& place = places_[begin];
  place.replacement = text;
  place.replaced = end - begin;
}

std::string Edits::Apply(const std::string& text) const {
  std::string result;
  unsigned done = 0;
  for (const auto& [offset, place] : places_) {
    if (offset > done) {
      result.append(text, done, offset - done);
      done = offset;
    }
    result += place.closing + place.opening + place.replacement;
    done += place.replaced;
  }
  result.append(text, done);
  return result;
}

}  // namespace plcxx::mutants
