// What editors ask of dialect host50.
#pragma once

#include "transpiler/dialects/common/editing.h"

namespace plcxx::host50 {

extern const dialects::Editing kEditing;

}  // namespace plcxx::host50
