#include "transpiler/project/baseline.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/yaml/document.h"

namespace plcxx::project {
namespace {

constexpr size_t kMaxBaselineBytes = 16u << 20;
constexpr char kSeparator = '\t';
constexpr const char* kHeading =
    "# Warnings that are accepted: code, how often, file, statement. Written by plcxx check --write-baseline.\n";

/// In one line, each run of blanks as one: what moves or is indented anew stays the same.
std::string InOneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (line.ends_with(' ')) line.pop_back();
  return diag::Escaped(line);
}

/// Names the statements that diagnostics are about.
class Entries {
 public:
  Entries(const compilation::Compilation& compilation, std::string folder)
      : sources_(*compilation.sources), folder_(std::move(folder)) {
    for (const ir::Statement& statement : compilation.program.statements) ranges_.push_back(statement.range);
    std::ranges::sort(ranges_, {}, &source::Range::begin);
  }

  /// "code \t file \t statement"
  std::string Of(const diag::Diagnostic& diagnostic) const {
    std::string entry(diagnostic.row->code);
    if (diagnostic.range == source::Range{}) return entry + kSeparator + kSeparator;
    const source::File& file = sources_.Get(sources_.FileAt(diagnostic.range.begin));
    const std::string name = std::filesystem::path(file.path).lexically_proximate(folder_).generic_string();
    return entry + kSeparator + InOneLine(name) + kSeparator + InOneLine(StatementOf(diagnostic.range, file));
  }

 private:
  /// The statement around the range; else the lines that it is in.
  std::string_view StatementOf(source::Range range, const source::File& file) const {
    auto after = std::ranges::upper_bound(ranges_, range.begin, {}, &source::Range::begin);
    if (after != ranges_.begin() && std::prev(after)->end >= range.end) return sources_.Text(*std::prev(after));
    const std::string_view text = file.text;
    const size_t begin = range.begin - file.base, end = std::min<size_t>(range.end - file.base, text.size());
    const size_t line_end = text.find_first_of("\r\n", end);
    const size_t before = begin == 0 ? std::string_view::npos : text.find_last_of("\r\n", begin - 1);
    const size_t line_begin = before == std::string_view::npos ? 0 : before + 1;
    return text.substr(line_begin, (line_end == std::string_view::npos ? text.size() : line_end) - line_begin);
  }

  const source::SourceManager& sources_;
  std::string folder_;
  std::vector<source::Range> ranges_;  // of statements, by their begin
};

/// "code \t 2 \t file \t statement" as how many of which.
bool TakeLine(std::string_view line, Baseline& baseline) {
  const size_t code_end = line.find(kSeparator);
  if (code_end == std::string_view::npos) return false;
  const size_t count_end = line.find(kSeparator, code_end + 1);
  if (count_end == std::string_view::npos || line.find(kSeparator, count_end + 1) == std::string_view::npos)
    return false;
  size_t count = 0;
  const char* const last = line.data() + count_end;
  const auto [end, error] = std::from_chars(line.data() + code_end + 1, last, count);
  if (error != std::errc() || end != last || count == 0) return false;
  baseline.accepted[std::string(line.substr(0, code_end)) + std::string(line.substr(count_end))] += count;
  return true;
}

}  // namespace

std::variant<Baseline, yaml::Error> ReadBaseline(const std::string& path) {
  std::variant<std::string, yaml::Fault> read = yaml::ReadText(path, kMaxBaselineBytes, "baseline");
  if (auto* fault = std::get_if<yaml::Fault>(&read))
    return yaml::Error{path, fault->mark, std::move(fault->message), "plcxx check --write-baseline makes it"};
  Baseline baseline;
  std::string_view text = std::get<std::string>(read);
  for (uint32_t number = 1; !text.empty(); ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#') || TakeLine(line, baseline)) continue;
    return yaml::Error{path,
                       {number, 1},
                       "an entry is a code, a count, a file and a statement, with tabs between them",
                       "plcxx check --write-baseline writes the file anew"};
  }
  return baseline;
}

std::string BaselineText(const compilation::Compilation& compilation, const std::string& folder) {
  const Entries entries(compilation, folder);
  std::map<std::string, size_t> counts;
  for (const diag::Diagnostic& diagnostic : compilation.diagnostics.all()) {
    if (diagnostic.row->severity != diag::Severity::kError) ++counts[entries.Of(diagnostic)];
  }
  std::string text = kHeading;
  for (const auto& [entry, count] : counts) {
    const size_t code_end = entry.find(kSeparator);
    text += entry.substr(0, code_end) + kSeparator + std::to_string(count) + entry.substr(code_end) + "\n";
  }
  return text;
}

compilation::Compilation CompileAccepting(const compilation::CompilationRequest& request, compilation::Stage until,
                                          const Baseline& baseline, const std::string& folder, Accepted& accepted) {
  compilation::CompilationRequest lenient = request;  // an accepted warning ends nothing
  lenient.warnings.errors.clear();
  lenient.warnings.all_errors = false;
  compilation::Compilation compilation = compilation::Compile(lenient, until);
  const Entries entries(compilation, folder);
  Baseline left = baseline;
  diag::WarningOptions options = request.warnings;
  for (const diag::Diagnostic& found : compilation.diagnostics.all()) {
    // What a dialect has turned on, or made an error of, by itself.
    options.enabled.emplace(found.row->code);
    if (found.severity == diag::Severity::kError && found.row->severity != diag::Severity::kError)
      options.errors.emplace(found.row->code);
  }
  diag::Engine diagnostics(std::move(options));
  for (const diag::Diagnostic& found : compilation.diagnostics.all()) {
    if (found.row->severity != diag::Severity::kError) {
      const auto entry = left.accepted.find(entries.Of(found));
      if (entry != left.accepted.end() && entry->second > 0) {
        --entry->second;
        ++accepted.warnings;
        continue;
      }
    }
    // What was reported is taken over; its text tells it from others of the same row at the same place.
    constexpr size_t kMostParameters = 10;
    diag::Diagnostic& kept =
        diagnostics.ReportRow(found.range, *found.row, std::vector<std::string>(kMostParameters, found.text));
    const diag::Severity severity = kept.severity;
    kept = found;
    kept.severity = severity;
  }
  for (const auto& [entry, count] : left.accepted) accepted.stale += count;
  compilation.diagnostics = std::move(diagnostics);
  return compilation;
}

}  // namespace plcxx::project
