// What the proofs of one program's functions share, and what each has for itself.
//
// Functions are proved by several threads: what they share is not changed while one of them is, and each has the rest
// to itself.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/replaced_call.h"
#include "transpiler/prove/verify/result_range.h"
#include "transpiler/prove/verify/state_image.h"
#include "transpiler/prove/verify/units.h"
#include "transpiler/prove/verify/verify.h"
#include "transpiler/symbolic/solver/answered.h"
#include "transpiler/symbolic/solver/deadline.h"

namespace plcxx::prove::verify {

struct VerifiedProgram {
  VerifiedProgram(const emit::Emittable& printed, const CodeShape& code_shape, VerifyLimits given)
      : emittable(printed),
        ir(*printed.program),
        shape(code_shape),
        limits(std::move(given)),
        cells(execute::MakeCells(ir)),
        image(ir, printed.layout, cells),
        units(MakeUnits(printed, cells)),
        unknown(units.all.size()) {
    for (const ir::RoutineId routine : shape.unknown) AddUnknown(units.of_routines[routine.index]);
  }

  std::string CppName(const Unit& unit) const { return CppName(unit.name); }
  std::string CppName(const std::string& name) const { return emittable.namespace_name + "::" + name; }

  const emit::Emittable& emittable;
  const ir::Program& ir;
  const CodeShape& shape;
  VerifyLimits limits;
  execute::Cells cells;
  StateImage image;
  Units units;
  std::vector<std::unique_ptr<ReplacedCall>> unknown;  // by UnitId: of those that are replaced wherever they are called

 private:
  void AddUnknown(UnitId unit) {
    if (!unit.valid()) return;
    unknown[unit.index] = std::make_unique<ReplacedCall>(emittable, cells, image, units[unit], shape.passes,
                                                         ParametersOf(emittable, units[unit], shape.passes),
                                                         RangeOfResult(ir, units[unit]));
  }
};

/// What one function is proved with.
struct Workplace {
  CompiledCode& code;
  /// By UnitId: those that are unknown, and of what the function calls, itself or through others, those that are
  /// proved.
  std::vector<const ReplacedCall*> calls;
  solver::Deadline deadline;
  /// Beginning with those of functions that come before it for sure: with what all others have found out by now, the
  /// solver's way, and the values that it shows of a difference, would depend on who was first.
  solver::AnsweredForms answered;
};

}  // namespace plcxx::prove::verify
