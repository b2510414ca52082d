// The steps of Legalize, one file each; legalize.cc has their order and its reasons.
#pragma once

#include "transpiler/emit/emittable.h"

namespace plcxx::emit::legalize {

void FindForegoneComparisons(Emittable& emittable);
void FindUsedHeaders(Emittable& emittable);
void FindUsedHostFunctions(Emittable& emittable);
void FindUsedFunctions(Emittable& emittable);
void NamePlaces(Emittable& emittable);
void PlaceTemporaries(Emittable& emittable);
void CutChunks(Emittable& emittable);
void CutParts(Emittable& emittable);
void ShareLocals(Emittable& emittable);
void ChooseLeaves(Emittable& emittable);
void PlaceEffects(Emittable& emittable);
void PlaceBraces(Emittable& emittable);
void ChooseWordings(Emittable& emittable);
void PlaceValues(Emittable& emittable);
void ShapeBranches(Emittable& emittable);
void FindCalledSubroutines(Emittable& emittable);
void NameLocals(Emittable& emittable);
void FindUsedParameters(Emittable& emittable);

}  // namespace plcxx::emit::legalize
