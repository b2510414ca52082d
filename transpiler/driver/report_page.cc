#include "transpiler/driver/report_page.h"

#include <charconv>
#include <string_view>
#include <utility>

#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"

namespace plcxx::driver {
namespace {

/// A budget among the options, in ns; 0: none.
uint64_t LimitNs(const compilation::Compilation& compilation, const std::string& option, uint64_t ns_per_unit) {
  const auto found = compilation.options.find(option);
  if (found == compilation.options.end()) return 0;
  uint64_t limit = 0;
  std::from_chars(found->second.data(), found->second.data() + found->second.size(), limit);
  return limit * ns_per_unit;
}

void AddGenerated(const compilation::Compilation& compilation, report::ProgramInput& input) {
  emit::EmitOptions options;
  options.name = compilation.name;
  const emit::Emittable emittable = emit::legalize::Legalize(compilation.program, options);
  input.local_names.resize(compilation.program.insts.size());
  for (emit::OutputFile& file : emit::print::PrintCpp(emittable, *compilation.sources)) {
    report::GeneratedFile generated{std::move(file.name), std::move(file.text), {}};
    for (const emit::LineOwner& owner : file.owners) generated.owners.push_back({owner.line, owner.statement});
    for (auto& [inst, name] : file.locals) input.local_names[inst] = name;
    input.generated.push_back(std::move(generated));
  }
}

void AddDocumented(const compilation::Compilation& compilation, report::ProgramInput& input) {
  const ir::NameIndex names(compilation.program);
  for (const ir::Documentation& known : compilation.program.documentation) {
    const auto location = compilation.dialect->locate(names, known.address);
    const bool is_place = location && !location->absent && !location->text_input && !location->cell;
    input.documented.push_back(is_place ? std::optional(location->place) : std::nullopt);
  }
}

}  // namespace

report::ProgramInput PageInput(const compilation::Compilation& compilation) {
  report::ProgramInput input;
  input.program = &compilation.program;
  input.sources = compilation.sources.get();
  input.files = compilation.files;
  input.control = compilation.dialect->title;
  AddGenerated(compilation, input);
  AddDocumented(compilation, input);
  for (const compilation::PartitionEstimate& partition : compilation.estimates.partitions) {
    const bool fast = partition.kind == ir::RoutineKind::kFast;
    input.partitions.push_back(
        {partition.name, partition.time_ns, partition.code_bytes,
         fast ? LimitNs(compilation, "fast-budget-us", 1000) : LimitNs(compilation, "slow-budget-ms", 1000000)});
  }
  input.slices = compilation.estimates.slices;
  input.slow_period_ms = compilation.estimates.slow_period_ms;
  if (!compilation.summary.resources.empty()) {
    report::Table resources{"Resources of the control", {"resource", "used", "available"}, {}};
    for (const dialects::ResourceUse& use : compilation.summary.resources) {
      resources.rows.push_back({std::string(use.name), std::to_string(use.used), std::to_string(use.available)});
    }
    input.tables.push_back(std::move(resources));
  }
  for (const dialects::SummaryTable& table : compilation.summary.tables) {
    input.tables.push_back({table.title, table.columns, table.rows});
  }
  return input;
}

}  // namespace plcxx::driver
