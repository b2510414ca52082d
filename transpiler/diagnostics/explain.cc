#include "transpiler/diagnostics/explain.h"

#include <algorithm>
#include <cctype>
#include <span>

#include "transpiler/diagnostics/explain_pages.h"

namespace plcxx::diag {
namespace {

std::span<const EmbeddedFile> Pages() { return {kExplainPages, kExplainPagesCount}; }

/// The file's name without ".md".
std::string_view CodeOf(const EmbeddedFile& page) {
  const std::string_view name = page.name;
  return name.substr(0, name.rfind('.'));
}

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace

std::optional<std::string_view> Explain(std::string_view code) {
  for (const EmbeddedFile& page : Pages()) {
    if (EqualIgnoringCase(CodeOf(page), code)) return std::string_view(page.text, page.size);
  }
  return std::nullopt;
}

std::vector<std::string_view> ExplainedCodes() {
  std::vector<std::string_view> codes;
  for (const EmbeddedFile& page : Pages()) codes.push_back(CodeOf(page));
  std::ranges::sort(codes);
  return codes;
}

}  // namespace plcxx::diag
