// What editors ask of dialect prostep.
#pragma once

#include "transpiler/dialects/common/editing.h"

namespace plcxx::prostep {

extern const dialects::Editing kEditing;

}  // namespace plcxx::prostep
