#include "tests/policy/explain.h"

#include <algorithm>
#include <optional>

#include "tests/temporary_directory.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::policy {
namespace {

const std::string_view kFence = "```";

bool Has(const Fence& fence, std::string_view word) {
  return std::ranges::find(fence.words, word) != fence.words.end();
}

std::optional<std::string> ValueOf(std::string_view word, std::string_view key) {
  if (!word.starts_with(key) || word.size() <= key.size() || word[key.size()] != '=') return std::nullopt;
  return std::string(word.substr(key.size() + 1));
}

std::string FileName(const Fence& fence) {
  for (const std::string& word : fence.words) {
    if (const auto name = ValueOf(word, "file")) return *name;
  }
  return {};
}

bool IsSource(const std::string& name) {
  return name.ends_with(".plc") || name.ends_with(".sym") || name.ends_with(".TCH");
}

compilation::Compilation CompileFence(const Fence& program, const std::vector<Fence>& fences) {
  const testing_support::TemporaryDirectory directory;
  compilation::CompilationRequest request;
  request.base_directory = directory.path().string();
  request.dialect = program.words.front();
  for (const Fence& fence : fences) {
    const std::string name = FileName(fence);
    if (name.empty()) continue;
    directory.Write(name, fence.text);
    if (IsSource(name)) request.sources.push_back(name);
  }
  directory.Write("program.plc", program.text);
  request.sources.insert(Has(program, "program=first") ? request.sources.begin() : request.sources.end(),
                         "program.plc");
  for (const std::string& word : program.words) {
    const auto setting = ValueOf(word, "set");
    if (!setting) continue;
    const size_t equals = setting->find('=');
    request.options.emplace_back(setting->substr(0, equals),
                                 equals == std::string::npos ? "" : setting->substr(equals + 1));
  }
  return compilation::Compile(request);
}

std::string Shown(const compilation::Compilation& compilation) {
  std::string text;
  for (const diag::Diagnostic& diagnostic : compilation.diagnostics.all()) {
    text += (text.empty() ? "" : "; ") + std::string(diagnostic.row->code) + " " + diagnostic.text;
  }
  return text.empty() ? "nothing" : text;
}

/// An error has to be the first error, so that nothing else explains the fault better; a warning has to be there,
/// in a program without errors.
bool Raises(const compilation::Compilation& compilation, const std::string& code) {
  for (const diag::Diagnostic& diagnostic : compilation.diagnostics.all()) {
    if (diagnostic.severity == diag::Severity::kError) return diagnostic.row->code == code;
    if (diagnostic.row->code == code && compilation.ok()) return true;
  }
  return false;
}

bool Mentions(const compilation::Compilation& compilation, const std::string& code) {
  return std::ranges::any_of(compilation.diagnostics.all(),
                             [&code](const diag::Diagnostic& diagnostic) { return diagnostic.row->code == code; });
}

}  // namespace

std::vector<Fence> Fences(std::string_view page) {
  std::vector<Fence> fences;
  bool inside = false;
  size_t number = 0;
  for (const std::string& line : Lines(page)) {
    ++number;
    if (line.starts_with(kFence)) {
      inside = !inside;
      if (inside) fences.push_back({Words(line.substr(kFence.size())), "", number});
    } else if (inside) {
      fences.back().text += line + "\n";
    }
  }
  return fences;
}

Findings CheckPagesExist(const std::vector<std::string>& codes, const std::vector<std::string>& pages) {
  Findings findings;
  for (const std::string& code : codes) {
    if (std::ranges::find(pages, code) == pages.end()) findings.push_back(code + ": no page in explain/");
  }
  for (const std::string& page : pages) {
    if (std::ranges::find(codes, page) == codes.end()) findings.push_back(page + ": no code of the catalogue");
  }
  return findings;
}

Findings CheckPage(const std::string& code, std::string_view page) {
  Findings findings;
  const std::string file = code + ".md";
  if (!page.starts_with("# " + code + ": ")) findings.push_back(Place(file, 1) + "expected '# " + code + ": title'");
  const std::vector<Fence> fences = Fences(page);
  bool shown = false;
  for (const Fence& fence : fences) {
    if (fence.words.empty()) {
      findings.push_back(Place(file, fence.line) + "a fence without words");
    } else if (fence.words.front() == "text") {
      shown = true;
    } else if (Has(fence, "wrong")) {
      shown = true;
      const compilation::Compilation compilation = CompileFence(fence, fences);
      if (!Raises(compilation, code)) {
        findings.push_back(Place(file, fence.line) + "the wrong program gives: " + Shown(compilation));
      }
    } else if (Has(fence, "right")) {
      const compilation::Compilation compilation = CompileFence(fence, fences);
      if (!compilation.ok() || Mentions(compilation, code)) {
        findings.push_back(Place(file, fence.line) + "the right program gives: " + Shown(compilation));
      }
    } else if (FileName(fence).empty()) {
      findings.push_back(Place(file, fence.line) + "a fence that is neither wrong, right, file= nor text");
    }
  }
  if (!shown) findings.push_back(file + ": neither a wrong program nor a text that shows the case");
  return findings;
}

}  // namespace plcxx::policy
