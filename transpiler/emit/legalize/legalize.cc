#include "transpiler/emit/legalize/legalize.h"

#include "transpiler/emit/legalize/steps.h"

namespace plcxx::emit::legalize {

Emittable Legalize(const ir::Program& program, const EmitOptions& options) {
  Emittable emittable;
  emittable.program = &program;
  emittable.options = options;
  emittable.layout = layout::MakeLayout(program);
  FindForegoneComparisons(emittable);  // before FindUsedFunctions: they are called by name
  FindUsedHostFunctions(emittable);
  NamePlaces(emittable);
  PlaceTemporaries(emittable);  // before CutChunks: a chunk never cuts between a value and its use
  CutChunks(emittable);
  CutParts(emittable);
  ShareLocals(emittable);     // after CutChunks: chunks get them, too
  ChooseLeaves(emittable);    // after CutChunks: what ends a function decides what `return` leaves
  PlaceEffects(emittable);    // after ChooseLeaves: a way out that needs no text asks for no value
  PlaceBraces(emittable);     // after PlaceEffects: around the locals; after ChooseLeaves: which arms are not nested
  ChooseWordings(emittable);  // after PlaceEffects: what has a name is not spelled inside
  FindUsedFunctions(emittable);
  FindUsedHeaders(emittable);  // after FindUsedFunctions: by them, too
  PlaceValues(emittable);      // after ChooseWordings: what is no assignment gives no result
  FindUsedParameters(emittable);
  NameLocals(emittable);     // after FindUsedParameters: no local has a parameter's name
  ShapeBranches(emittable);  // after PlaceEffects: whether an arm holds anything but an If
  FindCalledSubroutines(emittable);
  return emittable;
}

}  // namespace plcxx::emit::legalize
