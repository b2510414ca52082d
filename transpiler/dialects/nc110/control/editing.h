// What editors ask of dialect nc110.
#pragma once

#include "transpiler/dialects/common/editing.h"

namespace plcxx::nc110 {

extern const dialects::Editing kEditing;

}  // namespace plcxx::nc110
