#include "transpiler/dialects/common/wiring.h"

namespace plcxx::dialects {

void ReportCannotRead(const std::string& path, const source::LoadError& error, diag::Engine& diagnostics) {
  diagnostics.Report({}, diag::CannotReadSource, path, error.detail, source::RemedyOf(error.problem));
}

void ReportNoBudget(Budget /*budget*/, uint64_t /*needed*/, uint64_t /*limit*/, source::FileId /*first*/,
                    const source::SourceManager& /*sources*/, diag::Engine& /*diagnostics*/) {}

}  // namespace plcxx::dialects
