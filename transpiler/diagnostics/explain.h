// The long text of each diagnostic: the pages of explain/, built into the program.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace plcxx::diag {

/// The page of a code ("nc110-41", in any case), in Markdown. The text lives as long as the program.
std::optional<std::string_view> Explain(std::string_view code);

/// The codes that have a page, sorted.
std::vector<std::string_view> ExplainedCodes();

}  // namespace plcxx::diag
