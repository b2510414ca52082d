#include "transpiler/driver/compile_report.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/measure/figures.h"
#include "transpiler/source/columns.h"
#include "transpiler/support/counted.h"

namespace plcxx::driver {
namespace {

/// Budgets and reports are in whole microseconds, as the control shows them; nothing that runs takes none.
uint64_t Microseconds(uint64_t ns) { return (ns + compilation::kNsPerUs - 1) / compilation::kNsPerUs; }

/// Without directory: the report must not depend on where the sources stand.
std::string FileName(const compilation::Compilation& compilation, source::FileId id) {
  return std::filesystem::path(compilation.sources->Get(id).path).filename().string();
}

}  // namespace

std::string ReportJson(const compilation::Compilation& compilation, const std::vector<std::string>& files,
                       const nlohmann::ordered_json& build) {
  nlohmann::ordered_json report;
  report["program"] = compilation.name;
  report["dialect"] = compilation.dialect->name;
  report["sources"] = nlohmann::ordered_json::array();
  for (const source::FileId id : compilation.files) {
    const source::File& file = compilation.sources->Get(id);
    report["sources"].push_back({{"file", FileName(compilation, id)},
                                 {"lines", compilation.sources->LineCount(id)},
                                 {"encoding", source::Name(file.encoding)}});
  }
  report["lines"] = compilation.summary.lines;
  report["statements"] = compilation.summary.statements;
  report["warnings"] = compilation.diagnostics.warning_count();
  report["errors"] = compilation.diagnostics.error_count();
  report["partitions"] = nlohmann::ordered_json::array();
  for (const compilation::PartitionEstimate& partition : compilation.estimates.partitions) {
    report["partitions"].push_back({{"name", partition.name},
                                    {"time_us", Microseconds(partition.time_ns)},
                                    {"time_ns", partition.time_ns},
                                    {"code_bytes", partition.code_bytes}});
  }
  if (!compilation.summary.resources.empty()) {
    report["resources"] = nlohmann::ordered_json::array();
    for (const dialects::ResourceUse& resource : compilation.summary.resources) {
      report["resources"].push_back(
          {{"name", resource.name}, {"used", resource.used}, {"available", resource.available}});
    }
  }
  if (!compilation.summary.raised_errors.empty()) {
    report["raised_errors"] = nlohmann::ordered_json::array();
    for (const dialects::RaisedError& error : compilation.summary.raised_errors) {
      const source::Position at = compilation.sources->Locate(error.range.begin);
      report["raised_errors"].push_back(
          {{"main", error.main}, {"sub", error.sub}, {"file", FileName(compilation, at.file)}, {"line", at.line}});
    }
  }
  report["slices"] = compilation.estimates.slices;
  report["period_ms"] = compilation.program.schedule.period_ms;
  report["slow_period_ms"] = compilation.estimates.slow_period_ms;
  report["files"] = files;
  if (!build.is_null()) report["build"] = build;
  return report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string ReportText(const compilation::Compilation& compilation) {
  std::string text = compilation.name + ": " + support::Counted(compilation.summary.lines, "line") + ", " +
                     support::Counted(compilation.summary.statements, "statement") + ", " +
                     CountText(compilation.diagnostics) + "\n";
  for (const compilation::PartitionEstimate& partition : compilation.estimates.partitions) {
    text += "  " + source::LeftAligned(partition.name, 6) +
            source::RightAligned(std::to_string(Microseconds(partition.time_ns)), 8) + " us" +
            source::RightAligned(std::to_string(partition.code_bytes), 10) + " bytes\n";
  }
  if (compilation.estimates.slow_period_ms > 0) {
    text += "  slow part in " + support::Counted(compilation.estimates.slices, "slice") + ", period " +
            std::to_string(compilation.estimates.slow_period_ms) + " ms\n";
  }
  return text;
}

}  // namespace plcxx::driver
