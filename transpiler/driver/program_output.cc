#include "transpiler/driver/program_output.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

/// Faults of the driver for which a dialect's specification fixes a code.
struct CannotWriteRow {
  std::string_view dialect;
  const diag::Message<diag::Text, diag::Text, diag::Text>* message;
};
constexpr CannotWriteRow kCannotWrite[] = {{"nc110", &diag::Nc110CannotWrite}};

}  // namespace

OutputKind KindOfOutput(const std::string& path) {
  if (path == "-") return OutputKind::kStandardOutput;
  std::error_code error;
  const std::filesystem::path named(path);
  const bool folder = !named.has_extension() || path.ends_with('/') || std::filesystem::is_directory(named, error);
  return folder ? OutputKind::kFolder : OutputKind::kFile;
}

void AddOutputOptions(CLI::App& command, OutputOptions& options) {
  const auto add = [&command](const char* option, std::string& value, const char* type, const char* meaning) {
    command.add_option(option, value, meaning)->type_name(type)->group("Output");
  };
  add("--name", options.name, "NAME", "Name of the program and its files; else from the first logic source");
  add("-o", options.directory, "DIR",
      "Directory of the files, made when missing; else that of plcxx.yaml, or the current one");
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
  const OutputKind kind = KindOfOutput(options.directory);
  if (kind == OutputKind::kStandardOutput && options.one_file == OneFile::kNo) {
    PrintUsageError("'-o -': several files do not fit into standard output; name a directory (./- is one called '-')");
    return std::nullopt;
  }
  if (kind == OutputKind::kFile && options.one_file == OneFile::kNo) {
    PrintUsageError("'-o " + options.directory + "' is a file, and several are written: name a directory (" +
                    options.directory + "/ is one)");
    return std::nullopt;
  }
  if (options.dependency_file == "-" && !CanBeWritten({options.dependency_file})) return std::nullopt;
  if (!options.dependency_file.empty()) {
    std::vector<std::string> paths = request->sources;
    paths.push_back(options.directory);
    const auto has_line_end = [](const std::string& path) { return path.find_first_of("\r\n") != std::string::npos; };
    if (std::ranges::any_of(paths, has_line_end)) {
      PrintUsageError("'--depfile': a rule of Make cannot name a file with a line end in its name; rename it");
      return std::nullopt;
    }
  }
  if (!options.name.empty()) request->name = options.name;
  return request;
}

std::vector<std::string> PathsRead(const compilation::Compilation& compilation, const CommonOptions& common) {
  std::vector<std::string> paths;
  if (common.program) paths.push_back(common.project);
  for (uint32_t i = 0; i < compilation.sources->size(); ++i) {
    const std::string& path = compilation.sources->Get(source::FileId(i)).path;
    if (!path.starts_with('<')) paths.push_back(path);  // "<stdin>"
  }
  return paths;
}

void ReportCannotWrite(const WriteFailure& failure, compilation::Compilation& compilation) {
  const diag::Message<diag::Text, diag::Text, diag::Text>* message = &diag::CannotWriteOutput;
  for (const CannotWriteRow& row : kCannotWrite) {
    if (row.dialect == compilation.dialect->name) message = row.message;
  }
  compilation.diagnostics.Report({}, *message, failure.path, failure.reason, failure.remedy);
  compilation.wrong_use = true;  // no fault of the program
}

}  // namespace plcxx::driver
