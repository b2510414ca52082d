// The files of page/ inside the tool: style and script of the page.
#pragma once

#include <string_view>

#include "transpiler/support/embedded_file.h"

namespace plcxx::report {

using support::EmbeddedFile;

extern const EmbeddedFile kPageFiles[];
extern const unsigned kPageFilesCount;

/// The text of one of them.
std::string_view PageFile(std::string_view name);

}  // namespace plcxx::report
