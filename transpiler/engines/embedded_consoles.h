// The files of consoles/ inside the tool, so that a moved binary can still build harnesses.
#pragma once

#include "transpiler/support/embedded_file.h"

namespace plcxx::engines {

using support::EmbeddedFile;

extern const EmbeddedFile kConsoleFiles[];
extern const unsigned kConsoleFilesCount;

}  // namespace plcxx::engines
