// Statements in the words of people, where a language's source has none.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::dialects {

/// A statement of a dialect as people read it: its source, or what the dialect makes of that.
std::string StatementText(std::string_view dialect, std::string_view source);

}  // namespace plcxx::dialects
