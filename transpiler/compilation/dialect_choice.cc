#include "transpiler/compilation/dialect_choice.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace plcxx::compilation {
namespace {

using dialects::Dialect;

std::string LowerCase(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

bool HasExtension(const Dialect& dialect, const std::vector<std::string>& paths) {
  return std::ranges::any_of(paths, [&](const std::string& path) {
    const std::string extension = LowerCase(std::filesystem::path(path).extension().string());
    return std::ranges::find(dialect.extensions, extension) != dialect.extensions.end();
  });
}

}  // namespace

const Dialect* ChooseDialect(std::string_view name, const std::vector<std::string>& paths, const Peek& peek) {
  if (!name.empty()) return dialects::DialectByName(name);
  std::vector<const Dialect*> candidates;
  for (const Dialect* dialect : dialects::AllDialects()) {
    if (HasExtension(*dialect, paths)) candidates.push_back(dialect);
  }
  if (candidates.size() == 1) return candidates.front();
  if (candidates.empty()) candidates.assign(dialects::AllDialects().begin(), dialects::AllDialects().end());
  for (const std::string& path : paths) {
    const std::string text = peek(path);
    if (text.empty()) continue;
    std::vector<const Dialect*> fitting;
    std::ranges::copy_if(candidates, std::back_inserter(fitting),
                         [&](const Dialect* dialect) { return dialect->recognize(text); });
    if (fitting.size() == 1) return fitting.front();
    if (!fitting.empty()) candidates = std::move(fitting);  // a later source may tell more
  }
  return nullptr;
}

std::vector<std::string_view> DialectNames() {
  std::vector<std::string_view> names;
  for (const Dialect* dialect : dialects::AllDialects()) names.push_back(dialect->name);
  return names;
}

}  // namespace plcxx::compilation
