#include "transpiler/dialects/technol/parser/internal.h"
#include "transpiler/dialects/technol/source/sources.h"

namespace plcxx::technol {

/// Tells tables from sources (4.5).
void Parser::TakeTables() {
  bool first = true;
  for (const source::FileId file : request_.files) {
    const std::string& path = context_.sources.Get(file).path;
    if (!IsTable(path)) {
      sources_.push_back(file);
      continue;
    }
    auto table = ReadTable(context_.sources, file, context_.settings, *request_.diagnostics);
    if (first) {
      context_.program.table = std::move(table);
    } else {
      const source::Offset begin = context_.sources.Get(file).base;
      context_.diagnostics.Report({begin, begin}, diag::TechnolTwoTables, path);
    }
    first = false;
  }
}

}  // namespace plcxx::technol
