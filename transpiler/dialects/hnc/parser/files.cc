#include "transpiler/dialects/hnc/parser/files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

#include "transpiler/dialects/hnc/parser/module.h"

namespace plcxx::hnc {
namespace {

constexpr source::Encoding kEncodings[] = {source::Encoding::kUtf8, source::Encoding::kGb18030};

std::string LowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The entry of a folder with this name, in any letter case; the name itself where it is there; empty: none. Of several
/// the first by name.
std::string EntryOf(const std::string& folder, const std::string& name) {
  std::error_code error;
  const std::filesystem::path base = folder.empty() ? "." : folder;
  if (name == "." || name == ".." || std::filesystem::exists(base / name, error)) return name;
  std::string found;
  const std::string wanted = LowerCase(name);
  for (std::filesystem::directory_iterator it(base, error), end; !error && it != end; it.increment(error)) {
    const std::string entry = it->path().filename().string();
    if (LowerCase(entry) == wanted && (found.empty() || entry < found)) found = entry;
  }
  return found;
}

/// The path of a file below a folder, with the letters that the file system has; empty: there is none.
std::string FindBelow(const std::string& folder, std::string path) {
  std::ranges::replace(path, '\\', '/');
  std::string found = folder;
  while (!path.empty()) {
    const size_t end = std::min(path.find('/'), path.size());
    const std::string name = path.substr(0, end);
    path.erase(0, std::min(end + 1, path.size()));
    if (name.empty()) continue;
    const std::string entry = EntryOf(found, name);
    if (entry.empty()) return {};
    found += entry;
    if (!path.empty()) found += '/';
  }
  std::error_code error;
  return std::filesystem::is_regular_file(found, error) ? found : std::string();
}

}  // namespace

source::LoadOptions LoadOptionsOf(std::optional<source::Encoding> chosen) {
  source::LoadOptions options;
  options.encoding = chosen;
  options.encodings = kEncodings;
  options.choice = source::Choice::kAlways;
  options.detection = source::Detection::kFallback;
  options.fallback = source::Encoding::kGb18030;
  options.undecodable = source::Undecodable::kByTheDialect;
  return options;
}

ProgramFiles::ProgramFiles(dialects::Request& request, const Settings& settings, LoadedFiles& loaded, Reuse* reuse)
    : request_(request), settings_(settings), loaded_(loaded), reuse_(reuse) {
  const source::FileId file = request.files.front();
  const std::string& path = request.sources->Get(file).path;
  const size_t name = path.find_last_of('/') + 1;
  main_folder_ = path.substr(0, name);
  main_name_ = path.substr(name);
  std::unique_ptr<SourceText> text = TextOf(file);
  main_ = text.get();
  texts_.emplace(path, std::move(text));
  known_.emplace(std::string(kMainFolder) + "/" + main_name_, main_);
}

std::unique_ptr<SourceText> ProgramFiles::TextOf(source::FileId file) {
  std::optional<SourceText> text;
  if (reuse_ != nullptr) text = reuse_->TextOf(*request_.sources, file);
  if (!text) text = Rewrite(*request_.sources, file);
  const bool shows_elsewhere = reuse_ != nullptr && !text->line_directives.empty();
  shows_elsewhere ? reuse_->Misfit() : ApplyLineDirectives(*request_.sources, *text);
  return std::make_unique<SourceText>(std::move(*text));
}

std::vector<const SourceText*> ProgramFiles::texts() const {
  std::vector<const SourceText*> texts;
  for (const auto& [path, text] : texts_) {
    if (text->file.valid()) texts.push_back(text.get());
  }
  return texts;
}

const SourceText* ProgramFiles::Open(const std::string& path) {
  const auto known = known_.find(path);
  if (known != known_.end()) return known->second;
  const SourceText* text = nullptr;
  const auto below = [&](std::string_view folder) { return path.starts_with(std::string(folder) + "/"); };
  if (below(kProductFolder)) {
    text = OpenProduct(path.substr(kProductFolder.size() + 1));
  } else if (below(kMainFolder)) {
    text = OpenBelow(main_folder_, path.substr(kMainFolder.size() + 1));
  } else {
    for (size_t i = 0; i < request_.include_directories.size(); ++i) {
      const std::string folder = std::string(kIncludeFolder) + std::to_string(i);
      if (!below(folder)) continue;
      std::string directory = request_.include_directories[i];
      if (!directory.empty() && !directory.ends_with('/')) directory += '/';
      text = OpenBelow(directory, path.substr(folder.size() + 1));
    }
  }
  known_.emplace(path, text);
  return text;
}

const SourceText* ProgramFiles::OpenProduct(const std::string& name) {
  const std::string lower = LowerCase(name);
  const bool named = !settings_.system_header.empty() && lower == LowerCase(settings_.system_header);
  const bool assumed = !assumed_header_.empty() && lower == LowerCase(assumed_header_);
  std::optional<std::string> text;
  std::string key = lower;
  if (IsSystemHeaderName(name) || named || assumed) {
    text = SystemHeader(settings_.abs);
    key = "plc.h";
    system_header_read_ = true;
  } else {
    text = StandardHeader(name, settings_.abs);
  }
  if (!text) return nullptr;
  std::unique_ptr<SourceText>& made = texts_["<" + key + ">"];
  if (!made) made = std::make_unique<SourceText>(ProductText(key, *text));
  return made.get();
}

const SourceText* ProgramFiles::OpenBelow(const std::string& folder, const std::string& path) {
  if (reuse_ != nullptr && !reuse_->fits()) return nullptr;  // loaded in their order when all is read again
  const std::string found = FindBelow(folder, path);
  if (found.empty()) return nullptr;
  const auto known = texts_.find(found);
  if (known != texts_.end()) return known->second.get();
  const auto before = loaded_.find(found);
  if (before != loaded_.end()) return texts_.emplace(found, TextOf(before->second)).first->second.get();
  const auto loaded = request_.sources->Load(found, LoadOptionsOf(request_.encoding));
  const auto* file = std::get_if<source::FileId>(&loaded);
  if (file == nullptr && reuse_ != nullptr) {
    reuse_->Misfit();
    return nullptr;
  }
  if (file == nullptr) {
    const auto& error = std::get<source::LoadError>(loaded);
    if (error.problem == source::LoadProblem::kEmpty) {
      return texts_.emplace(found, std::make_unique<SourceText>(ProductText(found, ""))).first->second.get();
    }
    request_.diagnostics->Report({}, diag::CannotReadSource, found, error.detail, source::RemedyOf(error.problem));
    return nullptr;
  }
  loaded_.emplace(found, *file);
  return texts_.emplace(found, TextOf(*file)).first->second.get();
}

}  // namespace plcxx::hnc
