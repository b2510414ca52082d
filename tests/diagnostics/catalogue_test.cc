#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/diagnostics/explain.h"
#include "transpiler/diagnostics/host_messages.h"

namespace plcxx::diag {
namespace {

template <class... Args>
constexpr size_t CountOf(const Message<Args...>&) {
  return sizeof...(Args);
}

struct Declared {
  const Row* row;
  size_t parameters;
};

const Declared kDeclared[] = {
#define PLCXX_DIAG(Key, ...) {&Key.row, CountOf(Key)},
#define PLCXX_DIAG_OFF(Key, ...) {&Key.row, CountOf(Key)},
#include "transpiler/diagnostics/catalogue.def"
#include "transpiler/diagnostics/catalogue_host.def"
#undef PLCXX_DIAG
#undef PLCXX_DIAG_OFF
};

/// What is wrong with the wording of a row; empty when nothing is. Rule 17 of the style.
std::string FaultOf(const Row& row, size_t parameters) {
  const std::string_view text = row.text;
  if (text.empty()) return "no text";
  const auto has_full_stop = [](std::string_view part) { return part.ends_with('.') && !part.ends_with("..."); };
  if (has_full_stop(text) || has_full_stop(row.remedy)) return "full stop";
  // An abbreviation, a keyword or a name may begin with capitals, a sentence may not.
  if (!text.starts_with("Cyrillic") && text.size() > 1 && std::isupper(static_cast<unsigned char>(text[0])) != 0 &&
      std::islower(static_cast<unsigned char>(text[1])) != 0) {
    return "capital at the beginning";
  }
  const size_t dash = row.code.find('-');
  if (dash == 0 || dash == std::string_view::npos || dash + 1 == row.code.size()) return "code without dialect";
  for (size_t i = 0; i < parameters; ++i) {
    const std::string place = "{" + std::to_string(i) + "}";
    if (text.find(place) == std::string_view::npos && row.remedy.find(place) == std::string_view::npos) {
      return "parameter " + std::to_string(i) + " is not used";
    }
  }
  for (const std::string_view part : {row.text, row.remedy}) {
    for (size_t at = part.find('{'); at != std::string_view::npos; at = part.find('{', at + 1)) {
      if (at + 1 < part.size() && part[at + 1] == '{') {
        ++at;
      } else if (at + 2 >= part.size() || part[at + 2] != '}' || part[at + 1] < '0' ||
                 static_cast<size_t>(part[at + 1] - '0') >= parameters) {
        return "no such parameter";
      }
    }
  }
  return {};
}

TEST(Catalogue, EveryRowIsWellWorded) {
  for (const Declared& declared : kDeclared) {
    EXPECT_EQ(FaultOf(*declared.row, declared.parameters), "") << declared.row->key;
  }
}

TEST(Catalogue, BadWordingIsFound) {
  const auto row = [](std::string_view text) { return Row{"Key", "test-1", Severity::kError, text, ""}; };
  EXPECT_EQ(FaultOf(row("fine {0}"), 1), "");
  EXPECT_EQ(FaultOf(row("a '{{' is fine"), 0), "");
  EXPECT_EQ(FaultOf(row("MUX is fine"), 0), "");
  EXPECT_NE(FaultOf(row("Not fine"), 0), "");
  EXPECT_NE(FaultOf(row("not fine."), 0), "");
  EXPECT_NE(FaultOf(row("not {1}"), 1), "");
  EXPECT_NE(FaultOf(row("not {0}"), 0), "");
  EXPECT_NE(FaultOf(row("not {"), 0), "");
  EXPECT_NE(FaultOf({"Key", "nodialect", Severity::kError, "not fine", ""}, 0), "");
}

TEST(Catalogue, KeysAreUnique) {
  std::set<std::string_view> keys;
  for (const Row& row : Catalogue()) EXPECT_TRUE(keys.insert(row.key).second) << row.key;
  EXPECT_EQ(keys.size(), std::size(kDeclared));
}

TEST(Catalogue, OnlyWarningsAreOffByDefault) {
  for (const Row& row : Catalogue()) EXPECT_FALSE(row.off_by_default && row.severity == Severity::kError) << row.key;
}

TEST(Explain, EveryCodeHasAPage) {
  for (const Row& row : Catalogue()) EXPECT_TRUE(Explain(row.code).has_value()) << row.code;
}

TEST(Explain, EveryPageHasACode) {
  std::set<std::string_view> codes;
  for (const Row& row : Catalogue()) codes.insert(row.code);
  for (const std::string_view code : ExplainedCodes()) EXPECT_TRUE(codes.contains(code)) << code;
}

TEST(Explain, ThePageIsTheFile) {
  const std::filesystem::path folder = std::filesystem::path(PLCXX_ROOT) / "transpiler/diagnostics/explain";
  size_t pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".md") continue;
    ++pages;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    const std::string code = entry.path().stem().string();
    EXPECT_EQ(Explain(code), text) << code;
    EXPECT_TRUE(text.starts_with("# " + code + ": ")) << code << ": the first line is '# code: title'";
  }
  EXPECT_EQ(ExplainedCodes().size(), pages);
}

TEST(Explain, InAnyCase) {
  for (const std::string_view code : ExplainedCodes()) {
    std::string lower;
    for (const char c : code) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_EQ(Explain(lower), Explain(code));
  }
  EXPECT_EQ(Explain("plcxx-0"), std::nullopt);
  EXPECT_EQ(Explain(""), std::nullopt);
}

TEST(Explain, CodesAreSorted) {
  const auto codes = ExplainedCodes();
  EXPECT_TRUE(std::is_sorted(codes.begin(), codes.end()));
}

}  // namespace
}  // namespace plcxx::diag
