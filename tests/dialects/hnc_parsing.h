// Programs of dialect hnc from texts in the test: the tree, and what was reported.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/dialects/hnc/parser/files.h"
#include "transpiler/dialects/hnc/parser/parser.h"

namespace plcxx::hnc {

struct Parsed {
  source::SourceManager sources;
  diag::Engine diagnostics;
  Unit unit;

  /// "3:7 E010", in the order of the source; the file's name in front where it is not the main source.
  std::vector<std::string> Messages(diag::Severity severity) {
    diagnostics.SortBySource();
    std::vector<std::string> texts;
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
      if (diagnostic.severity != severity) continue;
      const source::Position position = sources.Locate(diagnostic.range.begin);
      std::string text = position.file.valid() && sources.Get(position.file).path != "test.cld"
                             ? sources.Get(position.file).path + ":"
                             : "";
      text += std::to_string(position.line) + ":" + std::to_string(position.column) + " ";
      texts.push_back(text + std::string(diagnostic.row->code.substr(4)));
    }
    return texts;
  }
  std::vector<std::string> Errors() { return Messages(diag::Severity::kError); }
  std::vector<std::string> Warnings() { return Messages(diag::Severity::kWarning); }
  std::string FirstText() {
    diagnostics.SortBySource();
    return diagnostics.all().empty() ? "" : diagnostics.all().front().text;
  }
  const Variable* Find(const std::string& name) const {
    for (const Variable& variable : unit.variables) {
      if (variable.name == name) return &variable;
    }
    return nullptr;
  }
  /// The folded value that initialises a variable.
  int64_t Initial(const std::string& name) const {
    const Variable* variable = Find(name);
    if (variable == nullptr || variable->initial.empty()) return -9999;
    const auto& constant = unit.expressions[variable->initial.front().value].constant;
    return constant ? constant->integer : -9998;
  }
  /// The statements of a function as print syntax shows them, without their lines.
  std::string Syntax() const { return PrintSyntax(sources, unit); }
};

inline constexpr const char* kEntries =
    "void init() { plc1_time = 16; plc2_time = 32; } void plc1() { } void plc2() { }\n";

inline void ParseInto(Parsed& parsed, const std::string& bytes, std::map<std::string, std::string> options = {}) {
  const auto loaded = parsed.sources.AddBytes("test.cld", bytes, LoadOptionsOf(std::nullopt));
  ASSERT_TRUE(std::holds_alternative<source::FileId>(loaded));
  dialects::Request request;
  request.sources = &parsed.sources;
  request.files = {std::get<source::FileId>(loaded)};
  request.options = std::move(options);
  request.diagnostics = &parsed.diagnostics;
  parsed.unit = Parse(request);
}

/// Line 1 includes the system header, line 2 has the entries, the text begins in line 3.
inline std::string Program(const std::string& text) { return "#include \"plc.h\"\n" + std::string(kEntries) + text; }

inline std::vector<std::string> ErrorsOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, Program(text));
  return parsed.Errors();
}

inline std::vector<std::string> WarningsOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, Program(text));
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text;
  return parsed.Warnings();
}

/// The value of a constant expression, folded with the widths of the language.
inline int64_t ValueOf(const std::string& expression, const std::string& type = "long") {
  Parsed parsed;
  ParseInto(parsed, Program(type + " value = " + expression + ";\n"));
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << expression;
  return parsed.Initial("value");
}

}  // namespace plcxx::hnc
