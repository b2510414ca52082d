#include "transpiler/dialects/common/printing.h"

namespace plcxx::dialects {

std::string PlaceText(const source::SourceManager& sources, source::Offset offset) {
  const source::Position position = sources.Locate(offset);
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

}  // namespace plcxx::dialects
