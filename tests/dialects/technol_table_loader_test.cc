// The loader of hosts reads and writes tables as the compiler does: the same first fault, the same bytes.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "plcxx/technology_tables.h"
#include "tests/dialects/technol_parsing.h"

namespace plcxx::technol {
namespace {

struct Loaded {
  std::string fault;  // "3 TT008"; empty: none
  TableImage image{};
};

Loaded ByCompiler(const std::string& text) {
  Parsed parsed;
  const auto loaded = parsed.sources.AddBytes("/nowhere/tab5.tch", text, SourceOptions());
  const auto* file = std::get_if<source::FileId>(&loaded);
  if (file == nullptr) return {.fault = "not a text"};
  const auto table = ReadTable(parsed.sources, *file, {}, parsed.diagnostics);
  if (table) return {.fault = {}, .image = ImageOf(*table)};
  parsed.diagnostics.SortBySource();
  const std::string first = parsed.Errors().front();
  return {.fault = first.substr(0, first.find(':')) + first.substr(first.find(' '))};
}

Loaded ByLoader(const std::string& text) {
  Loaded loaded;
  const TechnologyTableFault fault = ReadTechnologyTable(text.data(), text.size(), "tab5.tch", loaded.image.data());
  if (fault.number == 0) return loaded;
  EXPECT_EQ(std::ranges::count(loaded.image, 0), kTableImageBytes) << "nothing is written";
  char code[32];
  std::snprintf(code, sizeof code, "%u TT%03u", fault.line, fault.number);
  return {.fault = code};
}

void ExpectSame(const std::string& text) {
  const Loaded compiler = ByCompiler(text);
  if (compiler.fault == "not a text") return;
  const Loaded loader = ByLoader(text);
  ASSERT_EQ(loader.fault, compiler.fault) << text;
  ASSERT_EQ(loader.image, compiler.image) << text;
  if (!compiler.fault.empty()) return;
  const size_t preamble = TechnologyTablePreamble(text.data(), text.size());
  std::string written(20'000, '\0');
  written.resize(WriteTechnologyTable(loader.image.data(), text.data(), preamble, written.data(), written.size()));
  ASSERT_EQ(written, WriteTable(compiler.image, text.substr(0, preamble)));
}

TEST(TechnolTableLoader, TablesOfTheScenarios) {
  size_t tables = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PLCXX_ROOT) / "tests/golden/technol/tables")) {
    if (!IsTable(entry.path().string())) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (text.empty()) continue;
    ExpectSame(text);
    ++tables;
  }
  EXPECT_GT(tables, 20u);
}

TEST(TechnolTableLoader, ChangedByOneCharacter) {
  const std::string right = "popis\r\n$TCH 1 3 2\r\n0: 1.5 -2 .25 \"x\" 01:\t12345.678 ; y\r\n -0.5\n 7\n";
  ASSERT_EQ(ByCompiler(right).fault, "");
  for (size_t at = 0; at < right.size(); ++at) {
    for (const char c : std::string_view("0195.:;\"-+ \t\n\rx$\x1A")) {
      std::string changed = right;
      changed[at] = c;
      ExpectSame(changed);
      changed = right;
      changed.insert(at, 1, c);
      ExpectSame(changed);
    }
    ExpectSame(right.substr(0, at) + right.substr(at + 1));
    if (at > 0) ExpectSame(right.substr(0, at));
  }
}

TEST(TechnolTableLoader, NamesAndCapacity) {
  TableImage image{};
  const std::string text = "$TCH 1 1 1 0: 5";
  EXPECT_EQ(ReadTechnologyTable(text.data(), text.size(), "TAB_TECHNOLOGY_1", image.data()).number, 15);
  EXPECT_EQ(ReadTechnologyTable("", 0, "TAB1.TCH", image.data()).number, 16);
  ASSERT_EQ(ReadTechnologyTable(text.data(), text.size(), "tab1.tch", image.data()).number, 0);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(image.data()) + 16), "TAB1.TCH");
  char small[8] = {};
  EXPECT_EQ(WriteTechnologyTable(image.data(), "", 0, small, 4), WriteTable(image, "").size());
  EXPECT_STREQ(small, "$TCH");
  // What stands in front of the preamble is none of it.
  const char breaks[] = {'\r', '\n'};
  std::string behind(100, '\0');
  behind.resize(WriteTechnologyTable(image.data(), breaks + 1, 1, behind.data(), behind.size()));
  EXPECT_EQ(behind, WriteTable(image, "\n"));
  EXPECT_EQ(behind.substr(0, 15), "\n$TCH 1 1 1\n00:");
  // Headers that are no table's; the digits of an item may be any.
  for (uint32_t digit = 0; digit < 16; ++digit) {
    image.fill(static_cast<uint8_t>(0x11 * digit));
    std::string written(20'000, '\0');
    written.resize(WriteTechnologyTable(image.data(), "", 0, written.data(), written.size()));
    EXPECT_EQ(written, WriteTable(image, ""));
    EXPECT_EQ(digit == 10, written.find("AAAA.AAA") != std::string::npos) << written.substr(0, 100);
  }
}

}  // namespace
}  // namespace plcxx::technol
