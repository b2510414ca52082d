#include "transpiler/symbolic/terms/samples.h"

#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/likely_values.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::terms {
namespace {

uint64_t OneValue(Random& random, uint32_t sample, uint8_t width, std::span<const uint64_t> constants) {
  const uint64_t next = random.Next();
  if (width == 1) {
    constexpr uint64_t kDensities[] = {128, 16, 240, 64};
    return (next & 255) < kDensities[sample % 4] ? 1 : 0;
  }
  switch (next >> 8 & 7) {
    case 0:
      return 0;
    case 1:
    case 2:
      return next >> 16 & 15;
    case 3:
      return ~uint64_t{0} - (next >> 16 & 3);
    case 4:
      return random.Next();
    default:
      return constants.empty() ? next : constants[(next >> 16) % constants.size()] + (next >> 11 & 3) - 1;
  }
}

}  // namespace

std::vector<std::vector<uint64_t>> SampleValues(const Terms& terms, std::span<const TermId> roots, uint32_t samples) {
  const std::vector<TermId> cone = ConeOf(terms, roots);
  std::vector<uint64_t> constants;
  AddConstants(terms, cone, constants);
  Random random(0x9E3779B97F4A7C15);
  std::vector<uint64_t> values(terms.size());
  std::vector<std::vector<uint64_t>> result;
  for (uint32_t sample = 0; sample < samples; ++sample) {
    for (const TermId id : cone) {
      values[id.index] = EvaluateTerm(
          terms, terms[id], [&](TermId operand) { return values[operand.index]; },
          [&](uint32_t) { return OneValue(random, sample, terms.Width(id), constants); });
    }
    std::vector<uint64_t>& of_roots = result.emplace_back();
    for (const TermId root : roots) of_roots.push_back(values[root.index]);
  }
  return result;
}

}  // namespace plcxx::terms
