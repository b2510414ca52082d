// The words of all dialects for the colours of editors: what their grammars are made from (editors/vscode).
#pragma once

#include <string>

namespace plcxx::driver {

/// JSON, made from the machine tables; the same bytes each time.
std::string VocabularyText();

}  // namespace plcxx::driver
