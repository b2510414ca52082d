// The words of a C text as it stands in its file, for colours and names: what the preprocessor leaves out is there,
// too.
//
// Not its job: what the program means; Clang reads it (parser.h).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "transpiler/dialects/common/editing.h"

namespace plcxx::hnc {

std::vector<dialects::EditorToken> CWords(const source::File& file);

std::span<const std::string_view> CKeywords();

}  // namespace plcxx::hnc
