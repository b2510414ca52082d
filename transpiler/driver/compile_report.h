// The compile report: what the original compilers print at the end, as JSON for tools and in short form for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"

namespace plcxx::driver {

/// <name>.report.json. `files` are the other files written, without directory; `build` is what plcxx build measured,
/// null where nothing was.
std::string ReportJson(const compilation::Compilation& compilation, const std::vector<std::string>& files,
                       const nlohmann::ordered_json& build);
/// A few lines for the terminal.
std::string ReportText(const compilation::Compilation& compilation);

}  // namespace plcxx::driver
