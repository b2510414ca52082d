// MEFI CNC836, CNC8x6, CNC8x9, CNC872: the TECHNOL language (also called PLC836).
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::technol {

extern const dialects::Dialect kTechnol;

}  // namespace plcxx::technol
