// What plcxx soak says: in text, and as a page.
#pragma once

#include <string>

#include "transpiler/soak/record.h"

namespace plcxx::driver {

/// For people: findings, what was reached and what was not, by place.
std::string SoakText(const soak::Record& record, const std::string& directory);
/// A page with each statement and what of it was reached.
std::string SoakPage(const soak::Record& record);

}  // namespace plcxx::driver
