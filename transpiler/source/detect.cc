#include "transpiler/source/detect.h"
namespace plcxx::source {
Encoding DetectEightBit(std::string_view, Encoding fallback) { return fallback; }
}  // namespace plcxx::source
