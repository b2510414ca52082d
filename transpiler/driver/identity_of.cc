#include "transpiler/driver/identity_of.h"

#include <array>
#include <charconv>
#include <filesystem>
#include <string>
#include <string_view>

#include "transpiler/support/sha256.h"
#include "transpiler/support/sized_text.h"

namespace plcxx::driver {
namespace {

constexpr size_t kOptionsDigits = 8, kDigestDigits = 32;

std::array<uint8_t, 3> ParsedVersion(std::string_view text) {
  std::array<uint8_t, 3> version{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (uint8_t& number : version) {
    at = std::from_chars(at, end, number).ptr;
    if (at != end) ++at;
  }
  return version;
}

std::string SourcesOf(const compilation::Compilation& compilation) {
  std::string all;
  for (uint32_t i = 0; i < compilation.sources->size(); ++i) {
    const source::File& file = compilation.sources->Get(source::FileId(i));
    support::AddSized(all, std::filesystem::path(file.path).filename().string());
    support::AddSized(all, file.text);
  }
  return all;
}

std::string OptionsOf(const compilation::Compilation& compilation) {
  std::string all;
  support::AddSized(all, compilation.dialect->name);
  for (const auto& [key, value] : compilation.options) {
    support::AddSized(all, key);
    support::AddSized(all, value);
  }
  for (const dialects::MacroOption& macro : compilation.macros)
    support::AddSized(all, macro.name + (macro.text ? "=" + *macro.text : std::string()));
  return all;
}

}  // namespace

identity::Identity IdentityOf(const compilation::Compilation& compilation,
                              const std::vector<emit::OutputFile>& generated) {
  std::string code;
  for (const emit::OutputFile& file : generated) {
    if (!file.name.ends_with(".hpp") && !file.name.ends_with(".cpp")) continue;
    support::AddSized(code, file.name);
    support::AddSized(code, file.text);
  }
  return {.program = compilation.name,
          .version = ParsedVersion(PLCXX_VERSION),
          .options = identity::FirstDigits(support::Sha256(OptionsOf(compilation)), kOptionsDigits),
          .sources = identity::FirstDigits(support::Sha256(SourcesOf(compilation)), kDigestDigits),
          .generated = identity::FirstDigits(support::Sha256(code), kDigestDigits)};
}

void AddIdentity(const identity::Identity& identity, const std::string& name, std::vector<emit::OutputFile>& files) {
  for (emit::OutputFile& file : files) {
    if (file.name == name + ".cpp") file.text += identity::ConstantText(identity);
  }
}

}  // namespace plcxx::driver
