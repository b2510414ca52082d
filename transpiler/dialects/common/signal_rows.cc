#include "transpiler/dialects/common/signal_rows.h"

namespace plcxx::dialects {

std::string TakeField(std::string_view& line) {
  std::string field;
  if (line.starts_with('"')) {
    size_t at = 1;
    for (; at < line.size(); ++at) {
      if (line[at] == '"') {
        if (at + 1 >= line.size() || line[at + 1] != '"') break;
        ++at;
      }
      field += line[at];
    }
    line.remove_prefix(std::min(at + 1, line.size()));
  } else {
    field = line.substr(0, line.find(','));
    line.remove_prefix(field.size());
  }
  if (!line.empty()) line.remove_prefix(1);
  return field;
}

}  // namespace plcxx::dialects
