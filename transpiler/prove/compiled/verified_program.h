// What the proofs of one program's functions share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/compiled/compiled_code.h"
#include "transpiler/prove/compiled/replaced_call.h"
#include "transpiler/prove/compiled/state_image.h"
#include "transpiler/prove/compiled/units.h"
#include "transpiler/prove/compiled/verify.h"
#include "transpiler/prove/solver/answered.h"

namespace plcxx::prove::compiled {

struct VerifiedProgram {
  VerifiedProgram(const emit::Emittable& printed, CompiledCode& compiled, const VerifyLimits& given)
      : emittable(printed),
        ir(*printed.program),
        code(compiled),
        limits(given),
        cells(execute::MakeCells(ir)),
        image(ir, printed.layout, cells),
        units(MakeUnits(printed, cells)),
        calls(units.all.size()) {}

  std::string CppName(const Unit& unit) const { return emittable.namespace_name + "::" + unit.name; }

  const emit::Emittable& emittable;
  const ir::Program& ir;
  CompiledCode& code;
  const VerifyLimits& limits;
  execute::Cells cells;
  StateImage image;
  Units units;
  std::vector<std::unique_ptr<ReplacedCall>> calls;  // by UnitId: of those that are proved
  std::unique_ptr<solver::AnsweredForms> answered = std::make_unique<solver::AnsweredForms>();
};

}  // namespace plcxx::prove::compiled
