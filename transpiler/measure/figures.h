// What plcxx build finds in the objects: findings of the audit, and the figures of its table and report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/measurement.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/measure/state.h"

namespace plcxx::measure {

struct SliceFigures {
  uint64_t slice = 0;
  ir::RegionId piece;  // of the program
  compile::Figures figures;
  StateBytes state;
};

struct PartitionFigures {
  std::string name;  // "fast"
  ir::RoutineId routine;
  compile::Figures figures;  // of a sliced one: a bound on each slice
  StateBytes state;
  std::vector<SliceFigures> slices;  // ascending
  bool slices_join = false;          // jumps lead from slice to slice, so that each may be as long as the whole
};

struct BuildFigures {
  std::vector<PartitionFigures> partitions;  // what the generated header declares, in its order
  uint64_t code_bytes = 0, constant_bytes = 0;
  uint64_t retentive_bytes = 0, volatile_bytes = 0;  // of one State
  std::string timing;                                // where the cycles come from
};

/// How the build was made, for table and report.
struct BuildWay {
  const compile::Target* target = nullptr;
  const compile::Toolchain* toolchain = nullptr;
  std::string level;
  uint64_t clock_hz = 0;  // 0: not told
};

/// None when the objects cannot be read: reported.
std::optional<compile::ProgramCode> ReadObjects(const std::vector<std::string>& objects, const compile::Target& target,
                                                compilation::Compilation& compilation);

/// Reports what the objects must not do.
void AuditObjects(const compile::ProgramCode& code, const emit::Emittable& emittable,
                  compilation::Compilation& compilation);

BuildFigures Measure(const compile::ProgramCode& code, const emit::Emittable& emittable,
                     const std::vector<emit::OutputFile>& files);

/// Rounded up.
uint64_t Nanoseconds(uint64_t cycles, uint64_t clock_hz);

/// The object "build" of the report.
nlohmann::ordered_json BuildJson(const BuildFigures& figures, const BuildWay& way);
/// The table for the terminal.
std::string BuildTable(const BuildFigures& figures, const BuildWay& way, const std::string& program);

}  // namespace plcxx::measure
