#include "transpiler/driver/program_output.h"

#include <algorithm>
#include <string_view>

#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

/// Faults of the driver for which a dialect's specification fixes a code.
struct CannotWriteRow {
  std::string_view dialect;
  const diag::Message<diag::Text, diag::Text>* message;
};
constexpr CannotWriteRow kCannotWrite[] = {{"nc110", &diag::Nc110CannotWrite}};

}  // namespace

void AddOutputOptions(CLI::App& command, OutputOptions& options) {
  const auto add = [&command](const char* option, std::string& value, const char* type, const char* meaning) {
    command.add_option(option, value, meaning)->type_name(type)->group("Output");
  };
  add("--name", options.name, "NAME", "Name of the program and its files; else from the first logic source");
  add("-o", options.directory, "DIR", "Directory of the files, made when missing; else the current one");
  add("--depfile", options.dependency_file, "FILE", "Also write the files read as a rule of Make");
}

std::optional<compilation::CompilationRequest> MakeNamedRequest(const CommonOptions& common,
                                                                const OutputOptions& options) {
  std::optional<compilation::CompilationRequest> request = MakeRequest(common);
  if (!request) return std::nullopt;
  if (!options.name.empty() && !IsFileName(options.name)) {
    PrintUsageError("'--name " + options.name + "' cannot name files: use letters, digits, '_', '-' and '.'");
    return std::nullopt;
  }
  if (options.directory == "-" && options.to_standard_output == StandardOutput::kNo) {
    PrintUsageError("'-o -': several files do not fit into standard output; name a directory (./- is one called '-')");
    return std::nullopt;
  }
  if (!options.dependency_file.empty()) {
    std::vector<std::string> paths = common.sources;
    paths.push_back(options.directory);
    const auto has_line_end = [](const std::string& path) { return path.find_first_of("\r\n") != std::string::npos; };
    if (std::ranges::any_of(paths, has_line_end)) {
      PrintUsageError("'--depfile': a rule of Make cannot name a file with a line end in its name; rename it");
      return std::nullopt;
    }
  }
  request->name = options.name;
  return request;
}

std::vector<std::string> PathsRead(const compilation::Compilation& compilation) {
  std::vector<std::string> paths;
  for (uint32_t i = 0; i < compilation.sources->size(); ++i) {
    const std::string& path = compilation.sources->Get(source::FileId(i)).path;
    if (!path.starts_with('<')) paths.push_back(path);  // "<stdin>"
  }
  return paths;
}

void ReportCannotWrite(const WriteFailure& failure, compilation::Compilation& compilation) {
  const diag::Message<diag::Text, diag::Text>* message = &diag::CannotWriteOutput;
  for (const CannotWriteRow& row : kCannotWrite) {
    if (row.dialect == compilation.dialect->name) message = row.message;
  }
  compilation.diagnostics.Report({}, *message, failure.path, failure.reason);
}

}  // namespace plcxx::driver
