// What editors ask of dialect technol.
#pragma once

#include "transpiler/dialects/common/editing.h"

namespace plcxx::technol {

extern const dialects::Editing kEditing;

}  // namespace plcxx::technol
