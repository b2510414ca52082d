// Variables as places of memory: shared by lowering, which owns a program's places, and locate, which names any of
// them.
//
// Every array of the engine is a space. Of the bits each has a byte, as in the engine, so that a computed number
// reaches each of them; records (timers, counters) lie one after the other.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "transpiler/dialects/classicladder/machine/machine.h"
#include "transpiler/ir/program.h"

namespace plcxx::classicladder {

/// What a record keeps that no variable names.
enum class Hidden : uint8_t { kBase, kInputWas, kBefore, kUpWas, kDownWas, kPartMs, kStarted };

/// The arrays of the engine, its sequential steps, the scheduler, locals.
void AddSpaces(ir::Program& program, const Sizes& sizes);
/// Of a program that AddSpaces has begun; sizes that nothing in it depends on have their default.
Sizes SizesOf(const ir::Program& program);

ir::SpaceId SpaceOf(Group group);
ir::SpaceId StepSpace();
ir::SpaceId SystemSpace();
ir::SpaceId RoutineSpace();

/// Bytes from one element of an array to the next.
uint32_t StrideOf(Group group);
/// Without a name. `index` is that of the array.
ir::Place PlaceAt(Group group, Part part, uint32_t index);
ir::Place HiddenPlace(Group group, Hidden part, uint32_t index);
/// Of the step with this index: whether it is active, and for how many ms.
ir::Place StepActive(uint32_t step);
ir::Place StepMs(uint32_t step);

}  // namespace plcxx::classicladder
