// What editors ask of dialect classicladder.
#pragma once

#include "transpiler/dialects/common/editing.h"

namespace plcxx::classicladder {

extern const dialects::Editing kEditing;

}  // namespace plcxx::classicladder
