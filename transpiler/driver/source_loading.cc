#include "transpiler/driver/source_loading.h"

#include <sys/stat.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "transpiler/driver/dialect_choice.h"

namespace plcxx::driver {
namespace {

constexpr std::string_view kStandardInput = "-";
constexpr std::string_view kStandardInputName = "<stdin>";
constexpr size_t kReadPiece = 64u << 10;

/// Standard input can be read once, but is looked at twice: to tell the dialect, and as a source.
class StandardInput {
 public:
  const std::string& Read(size_t max_bytes) {
    if (bytes_) return *bytes_;
    bytes_.emplace();
    std::string piece(kReadPiece, '\0');
    while (bytes_->size() <= max_bytes && std::cin) {
      std::cin.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      bytes_->append(piece, 0, static_cast<size_t>(std::cin.gcount()));
    }
    return *bytes_;
  }

 private:
  std::optional<std::string> bytes_;
};

std::variant<source::FileId, source::LoadError> LoadOne(source::SourceManager& sources, StandardInput& input,
                                                        const std::string& path, const source::LoadOptions& options) {
  if (path != kStandardInput) return sources.Load(path, options);
  return sources.AddBytes(std::string(kStandardInputName), input.Read(options.max_bytes), options);
}

std::string ReasonOf(const source::LoadError& error) {
  if (!error.detail.empty()) return error.detail;
  switch (error.problem) {
    case source::LoadProblem::kMissing:
      return "no such file";
    case source::LoadProblem::kDirectory:
      return "it is a directory";
    case source::LoadProblem::kUnreadable:
      return "it cannot be opened";
    case source::LoadProblem::kTooLarge:
      return "it is too large";
    case source::LoadProblem::kLineTooLong:
      return "line " + std::to_string(error.line) + " is too long";
    case source::LoadProblem::kBinary:
      return "it is no text";
    case source::LoadProblem::kEmpty:
      return "it is empty";
  }
  return {};
}

/// The text for recognition, from a source manager of its own: another dialect may read the file in another way.
/// While no dialect is known, an unreadable file is reported in the words of all dialects.
std::string PeekText(StandardInput& input, const std::string& path, const source::LoadOptions& options,
                     diag::Engine& diagnostics) {
  source::SourceManager scratch;
  const auto loaded = LoadOne(scratch, input, path, options);
  if (const auto* file = std::get_if<source::FileId>(&loaded)) return scratch.Get(*file).text;
  diagnostics.Report({}, diag::CannotReadSource, path, ReasonOf(std::get<source::LoadError>(loaded)));
  return {};
}

/// What makes two paths one file; the path itself where there is no file.
std::string IdentityOf(const std::string& path) {
  struct stat status = {};
  if (path == kStandardInput || stat(path.c_str(), &status) != 0) return path;
  return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
}

bool HasSourceTwice(const std::vector<std::string>& paths, diag::Engine& diagnostics) {
  bool found = false;
  std::set<std::string> seen;
  for (const std::string& path : paths) {
    if (seen.insert(IdentityOf(path)).second) continue;
    diagnostics.Report({}, diag::SameSourceTwice, path);
    found = true;
  }
  return found;
}

/// Looks at `path` below base_directory, then below each include directory.
dialects::FileLoader MakeLoader(const CompilationRequest& request, source::SourceManager* sources,
                                const source::LoadOptions& options) {
  std::vector<std::string> directories = {request.base_directory};
  directories.insert(directories.end(), request.include_directories.begin(), request.include_directories.end());
  return [directories = std::move(directories), sources, options](const std::string& path) {
    auto first = sources->Load(FromBase(directories.front(), path), options);
    for (size_t i = 1; i < directories.size(); ++i) {
      const auto* error = std::get_if<source::LoadError>(&first);
      if (error == nullptr || error->problem != source::LoadProblem::kMissing) break;
      auto next = sources->Load(FromBase(directories[i], path), options);
      if (std::holds_alternative<source::FileId>(next)) return next;
    }
    return first;
  };
}

}  // namespace

std::string FromBase(const std::string& base_directory, const std::string& path) {
  if (base_directory.empty() || path == kStandardInput || std::filesystem::path(path).is_absolute()) return path;
  return (std::filesystem::path(base_directory) / path).string();
}

void LoadSources(const CompilationRequest& request, Compilation& compilation) {
  std::vector<std::string> paths;
  for (const std::string& path : request.sources) paths.push_back(FromBase(request.base_directory, path));
  if (HasSourceTwice(paths, compilation.diagnostics)) {
    compilation.wrong_use = true;
    return;
  }

  StandardInput input;
  source::LoadOptions options;
  options.encoding = request.encoding;
  compilation.dialect = ChooseDialect(request.dialect, paths, [&](const std::string& path) {
    return PeekText(input, path, options, compilation.diagnostics);
  });
  if (compilation.diagnostics.HasErrors()) return;
  if (compilation.dialect == nullptr) {
    const std::string subject = request.dialect.empty() ? paths.front() : request.dialect;
    compilation.diagnostics.Report({}, diag::UnknownDialect, subject, DialectNames());
    compilation.wrong_use = true;
    return;
  }

  options = compilation.dialect->load;
  if (request.encoding) options.encoding = request.encoding;
  for (const std::string& path : paths) {
    const auto loaded = LoadOne(*compilation.sources, input, path, options);
    if (const auto* file = std::get_if<source::FileId>(&loaded)) {
      compilation.files.push_back(*file);
    } else {
      compilation.dialect->report_load_error(path, std::get<source::LoadError>(loaded), compilation.diagnostics);
    }
  }
  compilation.load = MakeLoader(request, compilation.sources.get(), options);
}

}  // namespace plcxx::driver
