// Parses technol programs given as text and shows what was reported, for the tests of the front end.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/source/sources.h"

namespace plcxx::technol {

struct Parsed {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Request request;
  Program program;

  Parsed() {
    request.sources = &sources;
    request.diagnostics = &diagnostics;
    request.load = [](const std::string&) { return source::LoadError{}; };
  }
  Parsed(const Parsed&) = delete;
  Parsed& operator=(const Parsed&) = delete;

  /// "2:5 TE010" of every error, in source order.
  std::vector<std::string> Errors() const { return Listed(diag::Severity::kError); }
  /// Without TW011: nearly every test leaves standard modules out.
  std::vector<std::string> Warnings() const {
    std::vector<std::string> warnings = Listed(diag::Severity::kWarning);
    std::erase_if(warnings, [](const std::string& line) { return line.ends_with("TW011"); });
    return warnings;
  }
  std::string FirstText() const { return diagnostics.all().empty() ? "" : diagnostics.all().front().text; }
  /// The instructions of all units as `print syntax` writes them, without marks.
  std::vector<std::string> Instructions() const;
  const Symbol* Find(std::string_view name) const {
    for (const Symbol& symbol : program.symbols) {
      if (symbol.name == name) return &symbol;
    }
    return nullptr;
  }

 private:
  std::vector<std::string> Listed(diag::Severity severity) const;
};

inline std::vector<std::string> Parsed::Listed(diag::Severity severity) const {
  std::vector<std::string> result;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity != severity) continue;
    const source::Position place = sources.Locate(diagnostic.range.begin);
    const std::string_view code = diagnostic.row->code;
    result.push_back(std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                     std::string(code.substr(code.find('-') + 1)));
  }
  return result;
}

inline std::vector<std::string> Parsed::Instructions() const {
  std::vector<std::string> result;
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op < Op::kMechanismBegin) result.push_back(ToText(program, instruction));
  }
  return result;
}

/// Several files are one program; a text with "$TCH" is a table.
inline void ParseInto(Parsed& parsed, const std::vector<std::string>& files, const Settings& settings = {}) {
  for (const std::string& bytes : files) {
    const bool table = bytes.find("$TCH") != std::string::npos;
    const auto loaded = parsed.sources.AddBytes(table ? "/nowhere/tab1.tch" : "/nowhere/a.plc", bytes, SourceOptions());
    if (const auto* file = std::get_if<source::FileId>(&loaded)) parsed.request.files.push_back(*file);
  }
  parsed.program = Parse(parsed.request, settings);
}

/// A program with these declarations (from line 2 on) and these lines of MODULE_MAIN.
inline std::string InProgram(std::string_view data, std::string_view code) {
  return "DATA\n" + std::string(data) + "DATA_END\nMODULE_MAIN\n" + std::string(code) + "MODULE_MAIN_END\nSTOP\n";
}

constexpr std::string_view kCells = "BITS: DFM A,B,C,Q\nX: DS 1\nW: DS 2\nD: DS 4\nP: DS 3\n";
constexpr uint32_t kFirstLine = 9;  // of the code behind these cells

/// Of lines of MODULE_MAIN behind kCells; their lines count from 1.
inline std::vector<std::string> CodeErrors(std::string_view code) {
  Parsed parsed;
  ParseInto(parsed, {InProgram(kCells, code)});
  std::vector<std::string> errors;
  for (const std::string& error : parsed.Errors()) {
    const size_t colon = error.find(':');
    errors.push_back(std::to_string(std::stoul(error.substr(0, colon)) - kFirstLine + 1) + error.substr(colon));
  }
  return errors;
}
inline std::vector<std::string> CodeItems(std::string_view code) {
  Parsed parsed;
  ParseInto(parsed, {InProgram(kCells, code)});
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << code;
  return parsed.Instructions();
}
inline std::vector<std::string> ErrorsOf(const std::string& text, const Settings& settings = {}) {
  Parsed parsed;
  ParseInto(parsed, {text}, settings);
  return parsed.Errors();
}
inline std::vector<std::string> WarningsOf(const std::string& text, const Settings& settings = {}) {
  Parsed parsed;
  ParseInto(parsed, {text}, settings);
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text;
  return parsed.Warnings();
}

}  // namespace plcxx::technol
