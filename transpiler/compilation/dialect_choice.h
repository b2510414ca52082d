// Which dialect the sources are written in: the user's word, else the file extension, else the text.
//
// In: paths as they will be opened, and how to read one. Out: a dialect, or the candidates for the message.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"

namespace plcxx::compilation {

/// The text of a source for recognition; empty when it cannot be read (which another phase reports).
using Peek = std::function<std::string(const std::string& path)>;

/// `name` as given with --dialect (may be empty). None when no dialect or more than one fits.
const dialects::Dialect* ChooseDialect(std::string_view name, const std::vector<std::string>& paths, const Peek& peek);

std::vector<std::string_view> DialectNames();

}  // namespace plcxx::compilation
