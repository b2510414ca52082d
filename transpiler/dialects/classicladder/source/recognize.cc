#include "transpiler/dialects/classicladder/source/recognize.h"

namespace plcxx::classicladder {

bool Recognize(std::string_view text) { return text.starts_with("_FILES_CLASSICLADDER"); }

}  // namespace plcxx::classicladder
