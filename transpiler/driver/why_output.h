// The answers of `plcxx why` as JSON: what a machine reads. Text is scenarios::WhyText.
#pragma once

#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/prove/properties/check.h"
#include "transpiler/review/properties/scenario.h"
#include "transpiler/scenarios/why.h"

namespace plcxx::driver {

std::string WhyJson(const scenarios::WhyAnswer& answer, const scenarios::WhyQuestion& question,
                    const compilation::Compilation& compilation);

/// Whether a signal can be on at all.
struct CanAnswer {
  std::string signal;
  bool is_bit = true;
  prove::properties::PropertyResult result;
  review::properties::PropertyScenario scenario;
};
std::string CanText(const CanAnswer& answer);
std::string CanJson(const CanAnswer& answer);

}  // namespace plcxx::driver
