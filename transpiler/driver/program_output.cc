#include "transpiler/driver/program_output.h"

#include <string_view>

namespace plcxx::driver {
namespace {

/// Faults of the driver for which a dialect's specification fixes a code.
struct CannotWriteRow {
  std::string_view dialect;
  const diag::Message<diag::Text, diag::Text>* message;
};
constexpr CannotWriteRow kCannotWrite[] = {{"nc110", &diag::Nc110CannotWrite}};

}  // namespace

std::vector<std::string> PathsRead(const Compilation& compilation) {
  std::vector<std::string> paths;
  for (uint32_t i = 0; i < compilation.sources->size(); ++i) {
    const std::string& path = compilation.sources->Get(source::FileId(i)).path;
    if (!path.starts_with('<')) paths.push_back(path);  // "<stdin>"
  }
  return paths;
}

void ReportCannotWrite(const WriteFailure& failure, Compilation& compilation) {
  const diag::Message<diag::Text, diag::Text>* message = &diag::CannotWriteOutput;
  for (const CannotWriteRow& row : kCannotWrite) {
    if (row.dialect == compilation.dialect->name) message = row.message;
  }
  compilation.diagnostics.Report({}, *message, failure.path, failure.reason);
}

}  // namespace plcxx::driver
