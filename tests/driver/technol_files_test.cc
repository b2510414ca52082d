// plcxx emit with TECHNOL sources: what a technology table and the numbers of ESET become beside the C++.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr std::string_view kTable = "popis\r\n$TCH 1 2 2\r\n00: 180.520 -5.1\r\n01: 12 .05\r\n";
constexpr std::string_view kFilesProgram =
    "DATA\nA: DS 1\nDATA_END\nMODULE_MAIN\nESET 20,5\nCALL S\nESET 3\nMODULE_MAIN_END\nS: ESET 20,5\nRET\nSTOP\n";

/// As 9.8.3 builds it from the table above.
std::string Image() {
  std::string image(1632, '\0');
  const auto put = [&](size_t offset, std::string_view bytes) { image.replace(offset, bytes.size(), bytes); };
  using namespace std::string_view_literals;
  put(0, "\x01\x00\x02\x00\x02\x00\xFF\xFF\x01"sv);
  put(16, "TAB1.TCH");
  put(32, "\x20\x05\x18\x00\x00\x51\x00\x80"sv);
  put(40, "\x00\x20\x01\x00\x50\x00\x00\x00"sv);
  return image;
}

// covers: TECHNOL-182
TEST(TechnolFiles, ATableAloneBecomesItsImageAndItsListing) {
  const Workplace work;
  work.Write("Tab1.tch", kTable);
  const Ran ran = work.Run("emit Tab1.tch -o out");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(work.Files("out"), UnorderedElementsAre("Tab1.bin", "Tab1.lst"));
  EXPECT_EQ(work.Read("out/Tab1.bin"), Image());
  EXPECT_EQ(work.Read("out/Tab1.lst"),
            "TAB1.TCH: version 1, 2 columns, 2 rows\n"
            "row   0 column  0     180.520  20 05 18 00\n"
            "row   0 column  1      -5.100  00 51 00 80\n"
            "row   1 column  0      12.000  00 20 01 00\n"
            "row   1 column  1       0.050  50 00 00 00\n");
}

// covers: TECHNOL-182 TECHNOL-194
TEST(TechnolFiles, ATableBesideAProgramToo) {
  const Workplace work;
  work.Write("tab1.tch", kTable);
  work.Write("main.plc", kFilesProgram);
  EXPECT_EQ(work.Run("emit -q main.plc tab1.tch -o out").code, 0);
  EXPECT_THAT(work.Files("out"), UnorderedElementsAre("main.hpp", "main.cpp", "main.map.json", "main.report.json",
                                                      "tab1.bin", "tab1.lst"));
  EXPECT_EQ(work.Read("out/tab1.bin"), Image());
  const auto report = nlohmann::json::parse(work.Read("out/main.report.json"));
  EXPECT_THAT(report["files"], UnorderedElementsAre("main.hpp", "main.cpp", "main.map.json", "tab1.bin", "tab1.lst"));
}

// covers: TECHNOL-183
TEST(TechnolFiles, AWrongTableGivesNoImage) {
  const Workplace work;
  work.Write("tab1.tch", "$TCH 1 1 2\n0: 1\n1: 1-\n");
  const Ran ran = work.Run("emit tab1.tch -o out");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.errors, HasSubstr("tab1.tch:3:4"));
  EXPECT_THAT(work.Files("out"), IsEmpty());
}

// covers: TECHNOL-198
TEST(TechnolFiles, TheReportHasTheNumbersOfAllEsets) {
  const Workplace work;
  work.Write("main.plc", kFilesProgram);
  EXPECT_EQ(work.Run("emit -q main.plc -o out").code, 0);
  const auto report = nlohmann::json::parse(work.Read("out/main.report.json"));
  EXPECT_EQ(report["raised_errors"], nlohmann::json::parse(R"([{"main": 3, "sub": 0, "file": "main.plc", "line": 7},
                                                               {"main": 20, "sub": 5, "file": "main.plc", "line": 5},
                                                               {"main": 20, "sub": 5, "file": "main.plc", "line": 9}])"));
}

}  // namespace
}  // namespace plcxx::driver
