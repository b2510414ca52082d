// What a misspelt location may have been meant to be.
#pragma once

#include <string>
#include <string_view>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"

namespace plcxx::scenarios {

/// ", did you mean 'U4A8'", of the names and addresses that the program uses; where none is near, what lists them.
std::string WhichLocations(const dialects::Dialect& dialect, const ir::Program& program, std::string_view text);

/// "'U4AA8' is no location of nc110, did you mean 'U4A8'".
std::string NoSuchLocation(const dialects::Dialect& dialect, const ir::Program& program, std::string_view text);

}  // namespace plcxx::scenarios
