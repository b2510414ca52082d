// Statements in the words of people, where a language's source has none.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"

namespace plcxx::dialects {

/// A statement of a dialect as people read it: its source, or what the dialect makes of that.
std::string StatementText(std::string_view dialect, std::string_view source);

/// By index of `statements`: lines of the sources that say elsewhere what the statement does, as the expression of a
/// compare box; empty in languages whose statements are in one place.
std::vector<std::vector<source::Range>> LinesElsewhere(std::string_view dialect, const source::SourceManager& sources,
                                                       std::span<const source::Range> statements);

}  // namespace plcxx::dialects
