// What editors ask of dialect hnc.
#pragma once

#include "transpiler/dialects/common/editing.h"

namespace plcxx::hnc {

extern const dialects::Editing kEditing;

}  // namespace plcxx::hnc
