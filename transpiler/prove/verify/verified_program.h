// What the proofs of one program's functions share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/replaced_call.h"
#include "transpiler/prove/verify/result_range.h"
#include "transpiler/prove/verify/state_image.h"
#include "transpiler/prove/verify/units.h"
#include "transpiler/prove/verify/verify.h"
#include "transpiler/symbolic/solver/answered.h"

namespace plcxx::prove::verify {

struct VerifiedProgram {
  VerifiedProgram(const emit::Emittable& printed, CompiledCode& compiled, const CodeShape& code_shape,
                  const VerifyLimits& given)
      : emittable(printed),
        ir(*printed.program),
        code(compiled),
        shape(code_shape),
        limits(given),
        cells(execute::MakeCells(ir)),
        image(ir, printed.layout, cells),
        units(MakeUnits(printed, cells)),
        calls(units.all.size()),
        is_unknown(units.all.size()) {
    for (const ir::RoutineId routine : shape.unknown) AddUnknown(units.of_routines[routine.index]);
  }

  std::string CppName(const Unit& unit) const { return CppName(unit.name); }
  std::string CppName(const std::string& name) const { return emittable.namespace_name + "::" + name; }

  const emit::Emittable& emittable;
  const ir::Program& ir;
  CompiledCode& code;
  const CodeShape& shape;
  const VerifyLimits& limits;
  execute::Cells cells;
  StateImage image;
  Units units;
  std::vector<std::unique_ptr<ReplacedCall>> calls;  // by UnitId: of those that are proved
  std::vector<bool> is_unknown;                      // by UnitId: replaced even where calls are followed
  std::unique_ptr<solver::AnsweredForms> answered = std::make_unique<solver::AnsweredForms>();

 private:
  void AddUnknown(UnitId unit) {
    if (!unit.valid()) return;
    is_unknown[unit.index] = true;
    calls[unit.index] = std::make_unique<ReplacedCall>(emittable, cells, image, units[unit], shape.passes,
                                                       ParametersOf(emittable, units[unit], shape.passes),
                                                       RangeOfResult(ir, units[unit]));
  }
};

}  // namespace plcxx::prove::verify
