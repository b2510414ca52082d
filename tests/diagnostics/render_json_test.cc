#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/diagnostics/reporting.h"

namespace plcxx::diag {
namespace {

using nlohmann::json;

TEST(RenderJson, NothingIsAnEmptyArray) { EXPECT_EQ(Reporting("x").Json(), "[]\n"); }

TEST(RenderJson, AllFields) {
  Reporting report("$\nЖ=IOA7 (\n");
  Diagnostic& diagnostic = report.engine.Report(report.Find("IOA7"), kBroken, "IOA7");
  diagnostic.notes.push_back({report.Find("("), "this one"});
  diagnostic.fixits.push_back({report.Find("O"), "0"});
  const json all = json::parse(report.Json());
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0], json::parse(R"({
    "code": "test-1", "severity": "error", "message": "'IOA7' is broken", "help": "mend it",
    "file": "a.plc", "line": 2, "column": 3, "endLine": 2, "endColumn": 7, "byteOffset": 5, "byteLength": 4,
    "notes": [{"message": "this one", "file": "a.plc", "line": 2, "column": 8, "endLine": 2, "endColumn": 9,
               "byteOffset": 10, "byteLength": 1}],
    "fixits": [{"replacement": "0", "file": "a.plc", "line": 2, "column": 4, "endLine": 2, "endColumn": 5,
                "byteOffset": 6, "byteLength": 1}]})"));
}

TEST(RenderJson, FieldsStandInTheirOrder) {
  Reporting report("x");
  report.engine.Report(report.Find("x"), kOdd);
  const std::string text = report.Json();
  EXPECT_TRUE(text.starts_with("[\n  {\n    \"code\": \"test-W7\",\n    \"severity\": \"warning\",\n")) << text;
}

TEST(RenderJson, WithoutPlace) {
  Reporting report("x");
  report.engine.Report({}, kOdd).notes.push_back({{}, "a note"});
  const json all = json::parse(report.Json());
  for (const char* field : {"file", "line", "column", "endLine", "endColumn", "byteOffset"}) {
    EXPECT_TRUE(all[0][field].is_null()) << field;
    EXPECT_TRUE(all[0]["notes"][0][field].is_null()) << field;
  }
}

TEST(RenderJson, ARangeOverSeveralLines) {
  Reporting report("ab\ncd\n");
  report.engine.Report(report.At(1, 4), kOdd);
  const json all = json::parse(report.Json());
  EXPECT_EQ(all[0]["endLine"], 2);
  EXPECT_EQ(all[0]["endColumn"], 2);
}

TEST(RenderJson, WhatIsNoUtf8IsReplaced) {
  Reporting report("\xFF", "a\xFF.plc");
  report.engine.Report(report.At(0, 1), kBroken, "\xFF");
  EXPECT_TRUE(json::accept(report.Json()));
}

}  // namespace
}  // namespace plcxx::diag
