#include "transpiler/project/proposal.h"

#include <algorithm>
#include <cctype>
#include <compare>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <tuple>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/support/counted.h"
#include "transpiler/support/file_names.h"
#include "transpiler/support/read_file.h"

namespace plcxx::project {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxFiles = 500;                     // of a folder
constexpr std::uintmax_t kMaxSourceBytes = 4u << 20;  // of a file that may be a source
constexpr size_t kMaxSources = 100;
constexpr size_t kMaxTrials = 130;  // compilations that look for an order

constexpr std::string_view kFewestErrors = "the one that has fewest errors";
constexpr std::string_view kFewestWarnings = "the one that has fewest warnings";

/// Files of a control that an option names, by the beginning of their names.
struct TableRow {
  std::string_view dialect, begin, option;
};
constexpr TableRow kTables[] = {
    {"nc110", "IOCFIL", "iocfil"},  {"nc110", "AXCFIL", "axcfil"},  {"nc110", "PGCFIL", "pgcfil"},
    {"nc110", "RUMES", "messages"}, {"nc110", "FILMS", "messages"}, {"nc110", "MESSAGES", "messages"},
    {"nc110", "LGCMNU", "menu"},    {"nc110", "HELP", "help"},
};

/// What people and tools put beside programs.
constexpr std::string_view kNoSources[] = {".yaml", ".yml", ".md", ".txt", ".json", ".hpp", ".cpp",      ".html",
                                           ".pdf",  ".zip", ".o",  ".a",   ".d",    ".py",  ".baseline", ".prop"};

std::vector<std::string> FoldersIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end && names.size() < kMaxFiles;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with('.') && !at->is_symlink(error) && at->is_directory(error)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// What editors and people call the version before.
constexpr std::string_view kBackups[] = {".bak", ".old", ".orig", ".sav", ".bk", ".$$$"};

std::string UpperCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string LowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string> FilesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end && names.size() < kMaxFiles;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with('.') && at->is_regular_file(error)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// The file that a backup is one of, by its name; empty: it is none.
std::string OriginalOf(const std::string& name) {
  if (name.ends_with('~')) return name.substr(0, name.size() - 1);
  const fs::path path = name;
  const std::string extension = LowerCase(path.extension().string());
  return std::ranges::find(kBackups, extension) != std::ranges::end(kBackups) ? path.stem().string() : std::string();
}

bool IsBackupOf(const std::string& name, const std::string& other) {
  const std::string original = UpperCase(OriginalOf(name));
  if (original.empty() || !OriginalOf(other).empty()) return false;
  return original == UpperCase(other) || original == UpperCase(fs::path(other).stem().string());
}

/// What systems and people write into the name of a copy.
constexpr std::string_view kCopyWords[] = {"copy",  "kopie", "copie", "copia", "копия",
                                           "Копия", "КОПИЯ", "old",   "backup"};

bool IsCalledACopy(const std::string& name) {
  std::string word;
  for (const char c : name + ".") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80) {
      word += c;
      continue;
    }
    if (std::ranges::find(kCopyWords, LowerCase(word)) != std::ranges::end(kCopyWords)) return true;
    word.clear();
  }
  return false;
}

/// Of two names of the same bytes: "door (2).plc" and "Copy of door.plc" are copies of "door.plc". Edits go to the file
/// that has the plain name, and it is the one to compile.
bool IsPlainer(const std::string& name, const std::string& other) {
  const auto order = [](const std::string& of) { return std::tuple(IsCalledACopy(of), of.size(), of); };
  return order(name) < order(other);
}

class Finder {
 public:
  Finder(const fs::path& folder, std::string_view dialect) : folder_(folder), wish_(dialect) {}

  /// None: no file is a source.
  std::optional<ProposedProgram> Find() {
    names_ = FilesIn(folder_);
    ChooseDialect();
    if (dialect_ == nullptr) return std::nullopt;
    program_.dialect = dialect_->name;
    for (const std::string& name : names_) Sort(name);
    DropBackups();
    if (program_.sources.empty()) return std::nullopt;
    DropForeign();
    if (program_.sources.empty()) return std::move(program_);
    DropIncluded();
    ChooseOrder();
    Describe();
    return std::move(program_);
  }

  /// Whether a file in it reads like a language: nothing is compiled.
  bool HasSources() const {
    return std::ranges::any_of(FilesIn(folder_),
                               [&](const std::string& name) { return DialectOfFile(name) != nullptr; });
  }

 private:
  const dialects::Dialect* DialectOfFile(const std::string& name) const {
    std::error_code error;
    if (fs::file_size(folder_ / name, error) > kMaxSourceBytes || error) return nullptr;
    const std::string extension = LowerCase(fs::path(name).extension().string());
    if (std::ranges::find(kNoSources, extension) != std::ranges::end(kNoSources)) return nullptr;
    compilation::CompilationRequest request;
    request.base_directory = folder_.string();
    request.sources = {name};
    return compilation::DialectOf(request);
  }

  void ChooseDialect() {
    if (!wish_.empty()) {
      dialect_ = dialects::DialectByName(wish_);
      program_.why_dialect = "as asked for";
    }
    std::map<const dialects::Dialect*, size_t> counts;
    for (const std::string& name : names_) {
      const dialects::Dialect* dialect = DialectOfFile(name);
      of_file_[name] = dialect;
      if (dialect != nullptr) ++counts[dialect];
    }
    if (dialect_ != nullptr || counts.empty()) return;
    size_t most = 0;
    for (const dialects::Dialect* dialect : dialects::AllDialects()) {  // in a fixed order: pointers have none
      if (counts[dialect] <= most) continue;
      most = counts[dialect];
      dialect_ = dialect;
    }
    program_.why_dialect = support::Counted(most, "file") + (most == 1 ? " reads" : " read") + " like it";
  }

  /// Of a file that was read: relative to the folder.
  std::string NameIn(const std::string& path) const {
    return fs::path(path).lexically_proximate(folder_).generic_string();
  }

  bool HasExtension(const std::string& name) const {
    const std::string extension = LowerCase(fs::path(name).extension().string());
    return std::ranges::find(dialect_->extensions, extension) != dialect_->extensions.end();
  }

  void Sort(const std::string& name) {
    std::error_code error;
    if (fs::is_empty(folder_ / name, error)) {
      program_.files.push_back({name, "left out", "", "it is empty"});
      return;
    }
    for (const TableRow& row : kTables) {
      const bool known = row.dialect == dialect_->name && UpperCase(name).starts_with(row.begin) && !HasExtension(name);
      const bool taken = std::ranges::any_of(program_.options, [&](const auto& o) { return o.first == row.option; });
      if (!known || taken) continue;
      program_.options.emplace_back(row.option, name);
      program_.files.push_back({name, std::string(row.option), "", "by its name"});
      return;
    }
    const bool by_extension = HasExtension(name);
    const bool is_source = of_file_[name] == dialect_ || (by_extension && of_file_[name] == nullptr);
    if (is_source && program_.sources.size() < kMaxSources) {
      program_.sources.push_back(name);
    } else {
      program_.files.push_back({name, "left out", "", "no source of " + std::string(dialect_->name)});
    }
  }

  /// The version before lies beside the one that runs, and so do copies: as sources they would define all of it twice.
  void DropBackups() {
    const std::vector<std::string> all = program_.sources;
    std::erase_if(program_.sources, [&](const std::string& source) {
      const auto found = std::ranges::find_if(all, [&](const std::string& other) { return IsBackupOf(source, other); });
      if (found == all.end()) return false;
      program_.files.push_back({source, "left out", "", "a backup of " + *found + ", by its name"});
      return true;
    });
    std::map<std::string, std::string> originals;  // of contents: the plainest name
    const auto contents = [&](const std::string& source) {
      return support::ReadFile(folder_ / source).value_or(source);
    };
    for (const std::string& source : program_.sources) {
      std::string& original = originals.emplace(contents(source), source).first->second;
      if (IsPlainer(source, original)) original = source;
    }
    std::erase_if(program_.sources, [&](const std::string& source) {
      const std::string& original = originals.at(contents(source));
      if (source == original) return false;
      program_.files.push_back({source, "left out", "", "the same bytes as " + original});
      return true;
    });
  }

  compilation::CompilationRequest Request() const {
    compilation::CompilationRequest request;
    request.base_directory = folder_.string();
    request.dialect = program_.dialect;
    request.sources = program_.sources;
    request.options = program_.options;
    return request;
  }

  /// What has the container of a language and another language in it: no order and no option would make it a program.
  void DropForeign() {
    std::erase_if(program_.sources, [&](const std::string& source) {
      compilation::CompilationRequest request = Request();
      request.sources = {source};
      const compilation::Compilation alone = compilation::Compile(request, compilation::Stage::kLowered);
      const auto& messages = alone.diagnostics.all();
      const auto foreign = std::ranges::find_if(messages, [](const diag::Diagnostic& message) {
        return message.row->key == diag::ClassicladderVersion.row.key;
      });
      if (foreign == messages.end()) return false;
      program_.files.push_back({source, "left out", "", foreign->text});
      program_.no_program = source + ": " + foreign->remedy;
      return true;
    });
  }

  /// What others include is no source of its own.
  void DropIncluded() {
    std::set<std::string> included;
    for (const std::string& source : std::vector<std::string>(program_.sources)) {
      compilation::CompilationRequest request = Request();
      request.sources = {source};
      const compilation::Compilation alone = compilation::Compile(request, compilation::Stage::kLowered);
      for (uint32_t i = 0; i < alone.sources->size(); ++i) {
        const source::FileId id(i);
        if (std::ranges::find(alone.files, id) == alone.files.end())
          included.insert(NameIn(alone.sources->Get(id).path));
      }
    }
    std::erase_if(program_.sources, [&](const std::string& source) {
      if (!included.contains(source) || program_.sources.size() == included.size()) return false;
      program_.files.push_back({source, "included", "", "a source includes it"});
      return true;
    });
  }

  struct Messages {
    size_t errors = 0, warnings = 0;
    auto operator<=>(const Messages&) const = default;
  };

  Messages MessagesOf(const std::vector<std::string>& sources) const {
    compilation::CompilationRequest request = Request();
    request.sources = sources;
    const compilation::Compilation compilation = compilation::Compile(request, compilation::Stage::kLowered);
    return {compilation.diagnostics.error_count(), compilation.diagnostics.warning_count()};
  }

  /// Names of signals in front, then by name; where that has errors, the order that has fewest. Warnings decide between
  /// orders without errors: declarations that follow the first module are one.
  void ChooseOrder() {
    std::vector<std::string>& sources = program_.sources;
    if (sources.size() < 2) return;
    program_.order = "by name";
    std::vector<std::string> best = sources;
    Messages fewest = MessagesOf(best);
    size_t trials = 0;
    const auto look_at = [&](const std::vector<std::string>& order) {
      ++trials;
      const Messages messages = MessagesOf(order);
      if (messages >= fewest) return;
      const bool by_errors = messages.errors < fewest.errors || program_.order == kFewestErrors;
      program_.order = by_errors ? kFewestErrors : kFewestWarnings;
      fewest = messages;
      best = order;
    };
    // Each in front of all others: what the others need.
    for (size_t again = 0; again < sources.size() && fewest > Messages{}; ++again) {
      const std::vector<std::string> from(best.begin(), best.end());  // look_at changes `best`
      for (size_t i = 1; i < from.size() && fewest > Messages{} && trials < kMaxTrials; ++i) {
        std::vector<std::string> order = from;
        std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i),
                    order.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        look_at(order);
      }
      if (best == from) break;
    }
    constexpr size_t kMostPermuted = 4;
    if (sources.size() <= kMostPermuted) {
      std::vector<std::string> order = sources;
      while (fewest.errors > 0 && trials < kMaxTrials && std::ranges::next_permutation(order).found) look_at(order);
    }
    sources = best;
  }

  void Describe() {
    const compilation::Compilation compilation = compilation::Compile(Request(), compilation::Stage::kChecked);
    std::map<std::string, std::string> encodings;  // of those that could be read
    for (const source::FileId id : compilation.files) {
      const source::File& loaded = compilation.sources->Get(id);
      encodings[NameIn(loaded.path)] = source::Name(loaded.encoding);
    }
    std::vector<ProposedFile> sources;
    for (const std::string& name : program_.sources) {
      ProposedFile file{name, "source", "", ""};
      const auto encoding = encodings.find(name);
      if (encoding != encodings.end()) file.encoding = encoding->second;
      file.reason = HasExtension(file.name) ? "by its extension" : "reads like one";
      if (encoding == encodings.end()) file.reason += ", but it cannot be read";
      sources.push_back(std::move(file));
    }
    std::set<std::string>& loaded = program_.loaded;
    for (uint32_t i = 0; i < compilation.sources->size(); ++i)
      loaded.insert(NameIn(compilation.sources->Get(source::FileId(i)).path));
    for (ProposedFile& file : program_.files) {
      if (file.what != "left out" || !loaded.contains(file.name)) continue;
      file.what = "included";
      file.reason = "a source includes it";
    }
    program_.files.insert(program_.files.begin(), sources.begin(), sources.end());
    const std::string counts = diag::CountsText(compilation.diagnostics);
    program_.check = counts.empty() ? "no errors, no warnings" : counts;
    program_.ok = compilation.ok();
    program_.name = compilation.name;
    const std::string folder = fs::weakly_canonical(folder_).filename().string();
    if (program_.sources.size() > 1 && support::IsFileName(folder)) program_.name = folder;
    if (!support::IsFileName(program_.name)) program_.name = "program";
  }

  fs::path folder_;
  std::string wish_;
  std::vector<std::string> names_;
  std::map<std::string, const dialects::Dialect*> of_file_;
  const dialects::Dialect* dialect_ = nullptr;
  ProposedProgram program_;
};

/// Folders in `name` (and itself) whose files read like a language, relative to `top`; nothing below one of them.
std::vector<std::string> FoldersWithSources(const fs::path& top, const std::string& name, std::string_view dialect) {
  constexpr std::ptrdiff_t kDeepest = 3;  // machine/PLC/source
  if (Finder(top / name, dialect).HasSources()) return {name};
  std::vector<std::string> found;
  if (std::ranges::count(name, '/') + 1 >= kDeepest) return found;
  for (const std::string& inner : FoldersIn(top / name)) {
    for (std::string& folder : FoldersWithSources(top, name + "/" + inner, dialect)) found.push_back(std::move(folder));
  }
  return found;
}

/// Folders with sources beside those of a program that it does not take.
void NameOtherFolders(const fs::path& top, std::string_view dialect, ProposedProgram& program) {
  for (const std::string& name : FoldersIn(top)) {
    const bool is_used =
        std::ranges::any_of(program.loaded, [&](const std::string& file) { return file.starts_with(name + "/"); });
    if (is_used) continue;
    for (const std::string& folder : FoldersWithSources(top, name, dialect)) {
      program.files.push_back(
          {folder + "/", "left out", "", "a folder with sources of its own: plcxx init in it makes another project"});
    }
  }
}

}  // namespace

std::vector<ProposedProgram> ProposePrograms(const std::string& folder, std::string_view dialect) {
  const fs::path top = folder.empty() ? fs::path(".") : fs::path(folder);
  if (std::optional<ProposedProgram> only = Finder(top, dialect).Find()) {
    NameOtherFolders(top, dialect, *only);
    return {std::move(*only)};
  }
  std::vector<ProposedProgram> programs;
  std::set<std::string> names;
  const auto add = [&](const std::string& name, std::string own) {
    std::optional<ProposedProgram> program = Finder(top / name, dialect).Find();
    if (!program) return false;
    NameOtherFolders(top / name, dialect, *program);
    program->folder = name;
    if (!support::IsFileName(own)) own = compilation::NameFrom(own);
    program->name = own;
    for (size_t number = 2; !names.insert(program->name).second; ++number)
      program->name = own + "_" + std::to_string(number);
    programs.push_back(std::move(*program));
    return true;
  };
  for (const std::string& name : FoldersIn(top)) {
    if (add(name, name)) continue;
    // The program of a machine may lie deeper, beside its drawings.
    const std::vector<std::string> deeper = FoldersWithSources(top, name, dialect);
    for (const std::string& inner : deeper) {
      std::string own = deeper.size() == 1 ? name : inner;
      std::ranges::replace(own, '/', '_');
      add(inner, own);
    }
  }
  return programs;
}

}  // namespace plcxx::project
