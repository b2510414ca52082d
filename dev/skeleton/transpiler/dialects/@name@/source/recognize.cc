#include "transpiler/dialects/@name@/source/recognize.h"

namespace plcxx::@name@ {

bool Recognize(std::string_view /*text*/) { return false; }  // its extension or --dialect only

}  // namespace plcxx::@name@
