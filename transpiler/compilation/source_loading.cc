#include "transpiler/compilation/source_loading.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/source/decode.h"
#include "transpiler/source/read_bytes.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::compilation {
namespace {

constexpr std::string_view kStandardInput = "-";
constexpr std::string_view kStandardInputName = "<stdin>";

/// Standard input can be read once, but is looked at twice: to tell the dialect, and as a source.
class Reader {
 public:
  explicit Reader(const CompilationRequest& request) {
    for (const auto& [path, text] : request.texts) texts_[FromBase(request.base_directory, path)] = text;
  }

  std::variant<std::string, source::LoadError> Read(const std::string& path, size_t max_bytes) {
    if (path == kStandardInput) {
      if (!standard_input_) standard_input_ = source::ReadStandardInput(max_bytes);
      return *standard_input_;
    }
    const auto text = texts_.find(path);
    if (text == texts_.end()) return source::ReadBytes(path, max_bytes);
    if (text->second.empty()) return source::LoadError{source::LoadProblem::kEmpty, "it is empty"};
    if (text->second.size() > max_bytes) return source::TooLarge(max_bytes);
    return text->second;
  }

 private:
  std::map<std::string, std::string> texts_;
  std::optional<std::variant<std::string, source::LoadError>> standard_input_;
};

/// Does UTF-8 end within a character, as in a file that was not copied to its end? Where nobody has asked for UTF-8,
/// something else has to speak for it: one last byte above 7FH is a letter of an 8-bit encoding ("; +24 B" in
/// Cyrillic).
bool IsCutOff(std::string_view bytes, const source::LoadOptions& options) {
  if (options.encoding && *options.encoding != source::Encoding::kUtf8) return false;
  if (options.detection == source::Detection::kFallback) return false;  // the fallback is meant for it
  bytes = bytes.substr(0, bytes.find_first_of(options.end_marks));
  constexpr size_t kLongestRest = 3;
  for (size_t rest = 1; rest <= std::min(kLongestRest, bytes.size()); ++rest) {
    const auto lead = static_cast<unsigned char>(bytes[bytes.size() - rest]);
    const size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : lead >= 0x80 ? 0 : 1;
    if (length == 0) continue;  // goes on a character
    const std::string_view before = bytes.substr(0, bytes.size() - rest);
    const bool is_lead = lead >= 0xC2 && lead <= 0xF4;
    const bool is_asked_for = options.encoding.has_value();
    const bool is_seen =
        rest > 1 || std::ranges::any_of(before, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    return is_lead && length > rest && (is_asked_for || is_seen) && source::IsValidUtf8(before);
  }
  return false;
}

std::variant<source::FileId, source::LoadError> LoadOne(source::SourceManager& sources, Reader& reader,
                                                        const std::string& path, const source::LoadOptions& options) {
  auto bytes = reader.Read(path, options.max_bytes);
  if (auto* error = std::get_if<source::LoadError>(&bytes)) return std::move(*error);
  const std::string& text = std::get<std::string>(bytes);
  if (IsCutOff(text, options)) {
    return source::LoadError{source::LoadProblem::kCutOff, "it ends in the middle of a UTF-8 character"};
  }
  return sources.AddBytes(path == kStandardInput ? std::string(kStandardInputName) : path, text, options);
}

/// The text for recognition, from a source manager of its own: another dialect may read the file in another way.
/// While no dialect is known, an unreadable file is reported in the words of all dialects.
std::string PeekText(Reader& reader, const std::string& path, const source::LoadOptions& options,
                     diag::Engine& diagnostics) {
  source::SourceManager scratch;
  const auto loaded = LoadOne(scratch, reader, path, options);
  if (const auto* file = std::get_if<source::FileId>(&loaded)) return scratch.Get(*file).text;
  const auto& error = std::get<source::LoadError>(loaded);
  diagnostics.Report({}, diag::CannotReadSource, path, error.detail, source::RemedyOf(error.problem));
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
  return [directories = std::move(directories), sources, options, texts = Reader(request)](const std::string& path) {
    Reader reader = texts;
    auto first = LoadOne(*sources, reader, FromBase(directories.front(), path), options);
    for (size_t i = 1; i < directories.size(); ++i) {
      const auto* error = std::get_if<source::LoadError>(&first);
      if (error == nullptr || error->problem != source::LoadProblem::kMissing) break;
      auto next = LoadOne(*sources, reader, FromBase(directories[i], path), options);
      if (std::holds_alternative<source::FileId>(next)) return next;
    }
    return first;
  };
}

void ReportNoDialect(const std::string& name, const std::vector<std::string>& paths, diag::Engine& diagnostics) {
  if (name.empty() && paths.empty()) {
    diagnostics.Report({}, diag::NoSources);
  } else if (name.empty()) {
    diagnostics.Report({}, diag::UnknownDialect, paths.front(), support::CommaSeparated(DialectNames()));
  } else {
    const std::vector<std::string_view> names = DialectNames();
    diagnostics.Report({}, diag::UnknownDialectName, name, support::CommaSeparated(names),
                       support::DidYouMean(name, names));
  }
}

void ReportEncoding(source::Encoding encoding, const dialects::Dialect& dialect, diag::Engine& diagnostics) {
  std::string names = "auto";
  for (const source::Encoding allowed : dialect.load.encodings) names += ", " + std::string(source::Name(allowed));
  diagnostics.Report({}, diag::EncodingOfAnotherDialect, source::Name(encoding), dialect.name, names);
}

}  // namespace

std::string FromBase(const std::string& base_directory, const std::string& path) {
  if (base_directory.empty() || path == kStandardInput || std::filesystem::path(path).is_absolute()) return path;
  return (std::filesystem::path(base_directory) / path).string();
}

void ReportUnread(Compilation& compilation) {
  const bool by_dialect =
      compilation.dialect != nullptr && compilation.dialect->load.undecodable == source::Undecodable::kByTheDialect;
  const source::SourceManager& sources = *compilation.sources;
  std::set<std::string_view> seen;  // a file that is included twice is loaded twice
  for (uint32_t i = 0; i < sources.size(); ++i) {
    const source::File& file = sources.Get(source::FileId(i));
    if (file.unread_bytes > 0 && seen.insert(file.path).second) {
      const source::Offset end = sources.WholeFile(source::FileId(i)).end;
      compilation.diagnostics.Report({end, end}, diag::TextBehindEndOfFile, file.path,
                                     static_cast<int64_t>(file.unread_bytes));
    }
    if (by_dialect || file.replaced.empty()) continue;
    constexpr source::Offset kReplacementBytes = 3;  // U+FFFD
    const source::Offset first = file.base + file.replaced.front();
    compilation.diagnostics.Report({first, first + kReplacementBytes}, diag::UndecodableText, file.path,
                                   static_cast<int64_t>(file.replaced.size()));
  }
}

const dialects::Dialect* DialectOf(const CompilationRequest& request) {
  std::vector<std::string> paths;
  for (const std::string& path : request.sources) paths.push_back(FromBase(request.base_directory, path));
  Reader reader(request);
  source::LoadOptions options;
  options.encoding = request.encoding;
  diag::Engine nobody_reads;
  return ChooseDialect(request.dialect, paths, [&](const std::string& path) {
    return path == kStandardInput ? std::string() : PeekText(reader, path, options, nobody_reads);
  });
}

void LoadSources(const CompilationRequest& request, Compilation& compilation) {
  std::vector<std::string> paths;
  for (const std::string& path : request.sources) paths.push_back(FromBase(request.base_directory, path));
  if (HasSourceTwice(paths, compilation.diagnostics)) {
    compilation.wrong_use = true;
    return;
  }

  Reader reader(request);
  source::LoadOptions options;
  options.encoding = request.encoding;
  compilation.dialect = ChooseDialect(request.dialect, paths, [&](const std::string& path) {
    return PeekText(reader, path, options, compilation.diagnostics);
  });
  if (compilation.diagnostics.HasErrors()) return;
  if (compilation.dialect == nullptr) {
    ReportNoDialect(request.dialect, paths, compilation.diagnostics);
    compilation.wrong_use = true;
    return;
  }

  options = compilation.dialect->load;
  if (request.encoding) {
    if (std::ranges::find(options.encodings, *request.encoding) == options.encodings.end()) {
      ReportEncoding(*request.encoding, *compilation.dialect, compilation.diagnostics);
      compilation.wrong_use = true;
      return;
    }
    options.encoding = request.encoding;
  }
  for (const std::string& path : paths) {
    const auto loaded = LoadOne(*compilation.sources, reader, path, options);
    const auto* error = std::get_if<source::LoadError>(&loaded);
    if (const auto* file = std::get_if<source::FileId>(&loaded)) {
      compilation.files.push_back(*file);
    } else if (error->problem == source::LoadProblem::kEmpty && compilation.dialect->reads_empty_files) {
      compilation.files.push_back(compilation.sources->AddText(path, ""));
    } else {
      compilation.dialect->report_load_error(path, std::get<source::LoadError>(loaded), compilation.diagnostics);
    }
  }
  compilation.load = MakeLoader(request, compilation.sources.get(), options);
}

}  // namespace plcxx::compilation
