// Technology tables: items, images, faults at their places, and tables written back.
#include "tests/dialects/technol_parsing.h"
#include "transpiler/dialects/technol/source/technology_items.h"

namespace plcxx::technol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> TableErrors(const std::string& text, const Settings& settings = {}) {
  Parsed parsed;
  const auto loaded = parsed.sources.AddBytes("/nowhere/TAB1.TCH", text, SourceOptions());
  ReadTable(parsed.sources, std::get<source::FileId>(loaded), settings, parsed.diagnostics);
  parsed.diagnostics.SortBySource();
  return parsed.Errors();
}

TechnologyTable TableOf(const std::string& text, const Settings& settings = {}) {
  Parsed parsed;
  const auto loaded = parsed.sources.AddBytes("/nowhere/tab108.tch", text, SourceOptions());
  auto table = ReadTable(parsed.sources, std::get<source::FileId>(loaded), settings, parsed.diagnostics);
  EXPECT_THAT(parsed.Errors(), IsEmpty()) << text;
  return table.value_or(TechnologyTable());
}

constexpr std::string_view kManual =
    "Technologicka tabulka 108\r\nvyska poloha cas\r\n$TCH 1 3 4\r\n00: 180.520  -5.1 0.0\r\n"
    "01: 252.222 -3.0 \"nebo -2\" 6.1\r\n02: 0.0 12.5 5.3 \"konec\r\n03:121.5 -5.6 0.08 ; x\r\n";

TEST(TechnolTables, ItemsOfTheManual) {
  const TechnologyTable table = TableOf(std::string(kManual));
  EXPECT_THAT(table.items, ElementsAre(0x00180520, 0x80005100, 0, 0x00252222, 0x80003000, 0x00006100, 0, 0x00012500,
                                       0x00005300, 0x00121500, 0x80005600, 0x00000080));
  EXPECT_EQ(table.preamble, "Technologicka tabulka 108\r\nvyska poloha cas\r\n");
  EXPECT_EQ(table.name, "TAB108.TCH");
  const TableImage image = ImageOf(table);
  EXPECT_THAT(std::vector<int>(image.begin(), image.begin() + 20),
              ElementsAre(1, 0, 3, 0, 4, 0, 0xFF, 0xFF, 1, 0, 0, 0, 0, 0, 0, 0, 'T', 'A', 'B', '1'));
  EXPECT_THAT(std::vector<int>(image.begin() + 32, image.begin() + 40),
              ElementsAre(0x20, 0x05, 0x18, 0x00, 0x00, 0x51, 0x00, 0x80));
}

TEST(TechnolTables, Numbers) {
  const auto value = [](std::string_view text) { return ReadItem(text).value; };
  EXPECT_EQ(value("+12.23"), 0x00012230u);
  EXPECT_EQ(value("-45."), 0x80045000u);
  EXPECT_EQ(value("12"), 0x00012000u);
  EXPECT_EQ(value(".05"), 0x00000050u);
  EXPECT_EQ(value("79999.999"), 0x79999999u);
  EXPECT_EQ(value("-0.000"), 0u);
  for (const char* text : {"80000", "123456", "1.2345", "000001"})
    EXPECT_EQ(ReadItem(text).fault, ItemFault::kRange) << text;
  for (const char* text : {"1.2.3", "-", ".", "+.", "1a", "1:"})
    EXPECT_EQ(ReadItem(text).fault, ItemFault::kMalformed) << text;
  EXPECT_EQ(ReadItem("180.520-5.1").fault, ItemFault::kNotSeparated);
  EXPECT_EQ(ReadItem("--5").fault, ItemFault::kMalformed);
}

TEST(TechnolTables, Faults) {
  EXPECT_THAT(TableErrors("text\n"), ElementsAre("1:1 TT001"));
  EXPECT_THAT(TableErrors(" \n"), ElementsAre("1:1 TT016"));
  EXPECT_THAT(TableErrors("$TCH1 1 1\n0: 1\n"), ElementsAre("1:5 TT002"));
  EXPECT_THAT(TableErrors("$TCH 2 21\n401\n"), ElementsAre("1:6 TT002", "1:8 TT003", "2:1 TT004"));
  EXPECT_THAT(TableErrors("$TCH 1 20 21\n"), ElementsAre("1:1 TT005"));
  EXPECT_THAT(TableErrors("$TCH 1 1 2\n1\n1: 1\n"), ElementsAre("2:1 TT006"));
  EXPECT_THAT(TableErrors("$TCH 1 1 2\n0: 1\n01 : 1\n"), ElementsAre("3:1 TT006"));
  EXPECT_THAT(TableErrors("$TCH 1 1 2\n0: 1\n2: 1\n"), ElementsAre("3:1 TT007"));
  EXPECT_THAT(TableErrors("$TCH 1 2 2\n0: 1\n1: 1\n\n"), ElementsAre("3:1 TT008", "3:4 TT008"));
  EXPECT_THAT(TableErrors("$TCH 1 1 2\n0: 1 2 x\n1: 1 2\n"), ElementsAre("2:6 TT009", "3:6 TT009"));
  EXPECT_THAT(TableErrors("$TCH 1 3 1\n0: 1.2.3 4-5 6\n"), ElementsAre("2:4 TT010")) << "the first fault of a row";
  EXPECT_THAT(TableErrors("$TCH 1 2 2\n0: 1-2\n1: 5 123456\n"), ElementsAre("2:4 TT011", "3:6 TT012"));
  EXPECT_THAT(TableErrors("$TCH 1 1 3\n0: 1\n1: 2\n"), ElementsAre("3:4 TT013"));
  EXPECT_THAT(TableErrors("$TCH 1 1 1\n0: 1 x\n"), ElementsAre("2:6 TT014"));
  EXPECT_THAT(TableErrors("$TCH 1 1 1\n0: 1\n1: 1\n"), ElementsAre("3:1 TT014"));
  EXPECT_THAT(TableErrors("$TCH 1 1 1\n0: 1 x:\n"), ElementsAre("2:6 TT006"));
}

TEST(TechnolTables, Options) {
  Settings settings;
  settings.table_version = TableVersion::kAny;
  settings.glued_items = GluedItems::kAccept;
  const TechnologyTable table = TableOf("$TCH 7 2 1\n0:180.520-5.1", settings);
  EXPECT_EQ(table.version, 7);
  EXPECT_THAT(table.items, ElementsAre(0x00180520, 0x80005100));
}

// covers: TECHNOL-195
TEST(TechnolTables, WrittenBack) {
  EXPECT_EQ(WriteTable(ImageOf(TableOf("popis\n$TCH 1 7 2\n0:1 2 3 4 5 6 -7.5 1: 0 0 0 0 0 0 12345.678")), "popis\n"),
            "popis\n$TCH 1 7 2\n"
            "00:      1.000      2.000      3.000      4.000      5.000      6.000\n"
            "        -7.500\n"
            "01:      0.000      0.000      0.000      0.000      0.000      0.000\n"
            "     12345.678\n");
  EXPECT_EQ(WriteTable(ImageOf(TableOf("$TCH 1 1 1 0: .5")), ""), "$TCH 1 1 1\r\n00:      0.500\r\n");
  TableImage wild = EmptyImage();
  wild.fill(0xFF);
  EXPECT_LT(WriteTable(wild, "").size(), 10'000u) << "a header that is no table's";
}

TEST(TechnolTables, AmongTheSources) {
  Parsed parsed;
  ParseInto(parsed, {InProgram("X: DS 1\n", "LOD X\nSTO X\n"), "$TCH 1 1 1 0: 5"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  ASSERT_TRUE(parsed.program.table.has_value());
  EXPECT_FALSE(parsed.program.tables_only);
  Parsed alone;
  ParseInto(alone, {"$TCH 1 1 1 0: 5"});
  EXPECT_TRUE(alone.program.tables_only);
  Parsed two;
  ParseInto(two, {"$TCH 1 1 1 0: 5", "$TCH 1 1 1 0: 6"});
  EXPECT_THAT(two.Errors(), ElementsAre("1:1 TE029"));
}

}  // namespace
}  // namespace plcxx::technol
