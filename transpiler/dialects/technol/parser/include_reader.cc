#include "transpiler/dialects/technol/parser/include_reader.h"

#include <algorithm>

#include "transpiler/dialects/technol/source/sources.h"
#include "transpiler/source/find_file.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kMostIncludes = 10'000;

std::string DirectoryOf(const std::string& path) {
  const size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

/// Without the quotes of a quoted name.
std::string_view PathOf(const Token& token) {
  return token.kind == TokenKind::kPath ? token.text : token.text.substr(1, token.text.size() - 2);
}

}  // namespace

/// A plain name beside the including source and below -I; a quoted one in the system's directories, then below -I.
std::optional<std::string> IncludeReader::FindInclude(std::string_view name, TokenKind form) const {
  std::vector<std::string> directories;
  if (form == TokenKind::kPath) {
    directories.push_back(DirectoryOf(context_.sources.Get(now_.file).path));
  } else {
    directories = request_.system_include_directories;
  }
  directories.insert(directories.end(), request_.include_directories.begin(), request_.include_directories.end());
  for (const std::string& directory : directories) {
    if (auto path = source::FindFile(directory, name)) return path;
  }
  return std::nullopt;
}

/// A name that climbs or is absolute may lead to what is no part of the program: only to where a source of the command
/// line is, or to a directory that an option gives.
bool IncludeReader::MayInclude(std::string_view name, const std::string& path) const {
  if (!source::LeavesDirectory(name)) return true;
  const auto is_above = [&](const std::string& directory) { return source::LiesBelow(path, directory); };
  return std::ranges::any_of(request_.include_directories, is_above) ||
         std::ranges::any_of(request_.system_include_directories, is_above) ||
         std::ranges::any_of(request_.files, [&](source::FileId file) {
           return is_above(DirectoryOf(context_.sources.Get(file).path));
         });
}

/// Not valid when the file cannot be read (reported). A file that is included again keeps its places.
source::FileId IncludeReader::LoadInclude(const std::string& path, const Token& name) {
  const std::string identity = source::FileIdentity(path);
  if (const auto known = included_.find(identity); known != included_.end()) return known->second;
  source::LoadOptions options = SourceOptions();
  options.encoding = request_.encoding;
  const auto loaded = request_.sources->Load(path, options);
  source::FileId file;
  if (const auto* found = std::get_if<source::FileId>(&loaded)) {
    file = *found;
  } else {
    const source::LoadError& error = std::get<source::LoadError>(loaded);
    if (error.problem != source::LoadProblem::kEmpty) {
      context_.Report(name.range, diag::TechnolIncludeMissing, PathOf(name), error.detail);
      return {};
    }
    file = request_.sources->AddText(path, "");
  }
  included_.emplace(identity, file);
  return file;
}

std::optional<IncludedFile> IncludeReader::ReadInclude(const Statement& statement) {
  if (CurrentUnit().valid()) {
    context_.Report(statement.range, diag::TechnolStrayLine, "T_INCLUDE", "stands outside modules and mechanisms");
    return std::nullopt;
  }
  if (statement.words.size() < 2) {
    context_.Report(statement.range, diag::TechnolOperandMissing, "T_INCLUDE", "the name of a file");
    return std::nullopt;
  }
  const Token& name = statement.words[1];
  if (name.kind == TokenKind::kOpenString) {
    context_.Report(name.range, diag::TechnolStringOpen, name.text);
    return std::nullopt;
  }
  if (!ExpectEnd(statement, 2)) return std::nullopt;
  if (statement.label != nullptr && !now_.in_data) code_.ReadLabel(statement);
  const std::optional<std::string> path = FindInclude(PathOf(name), name.kind);
  if (!path) {
    context_.Report(name.range, diag::TechnolIncludeMissing, PathOf(name), "no such file");
    return std::nullopt;
  }
  if (!MayInclude(PathOf(name), *path)) {
    context_.Report(name.range, diag::TechnolIncludeOutside, PathOf(name));
    return std::nullopt;
  }
  const std::string identity = source::FileIdentity(*path);
  if (std::ranges::find(now_.including, identity) != now_.including.end()) {
    context_.Report(name.range, diag::TechnolIncludeItself, PathOf(name));
    return std::nullopt;
  }
  if (now_.including.size() > kIncludeDepth) {
    context_.Report(name.range, diag::TechnolIncludeDepth, PathOf(name));
    return std::nullopt;
  }
  if (++count_ >= kMostIncludes) {
    if (count_ == kMostIncludes) context_.Report(name.range, diag::TechnolIncludeCount, PathOf(name));
    return std::nullopt;
  }
  const source::FileId file = LoadInclude(*path, name);
  if (!file.valid()) return std::nullopt;
  return IncludedFile{file, identity};
}

void IncludeReader::ReadSystemHeader(const Statement& statement) {
  if (statement.words.size() < 2) {
    context_.Report(statement.range, diag::TechnolOperandMissing, "INCLUDE", "the name of a file");
    return;
  }
  const Token& name = statement.words[1];
  if (!Upper(PathOf(name)).ends_with(".ASH")) {
    context_.Report(statement.range, diag::TechnolIncludeForeign, PathOf(name));
    return;
  }
  if (ExpectEnd(statement, 2)) context_.Report(statement.range, diag::TechnolSystemHeader, PathOf(name));
}

}  // namespace plcxx::technol
