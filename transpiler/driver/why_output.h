// The answers of `plcxx why` as JSON: what a machine reads. Text is scenarios::WhyText.
#pragma once

#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/prove/properties/check.h"
#include "transpiler/review/properties/scenario.h"
#include "transpiler/scenarios/traced_run.h"
#include "transpiler/scenarios/why.h"

namespace plcxx::driver {

/// How far the run is that of a trace. Notes are sentences, in which long lists are cut short; departures are all.
struct TraceComparison {
  std::vector<scenarios::Departure> departures;
  std::vector<std::string> notes;
};

/// `trace` is null when the run is no trace's.
std::string WhyJson(const scenarios::WhyAnswer& answer, const scenarios::WhyQuestion& question,
                    const compilation::Compilation& compilation, const TraceComparison* trace);

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
