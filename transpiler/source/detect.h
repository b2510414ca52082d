// Which of the 8-bit encodings a text that is not UTF-8 was written in.
//
// In: the bytes. Out: the encoding in which they read most like Russian, or the fallback where nothing speaks for any.
// Deterministic: the same bytes give the same answer on every machine. Method and tables: detect.cc.
#pragma once

#include <string_view>

#include "transpiler/source/source.h"

namespace plcxx::source {

Encoding DetectEightBit(std::string_view bytes, Encoding fallback);

}  // namespace plcxx::source
