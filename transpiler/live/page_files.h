// The files of page/ inside the tool.
#pragma once

#include "transpiler/support/embedded_file.h"

namespace plcxx::live {

using support::EmbeddedFile;

extern const EmbeddedFile kLivePageFiles[];
extern const unsigned kLivePageFilesCount;

}  // namespace plcxx::live
