// The parser's state and its functions, split over parser_*.cc by parts. Only those files include it.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/dialects/classicladder/parser/parser.h"
#include "transpiler/dialects/classicladder/source/lines.h"

namespace plcxx::classicladder {

/// A part of the project with its lines, without its marks.
struct FilePart {
  PartKind kind{};
  uint32_t rung = 0;
  std::string_view name;
  source::Range range;  // of the name
  std::vector<Line> lines;
};

/// A piece of a line between commas.
struct Field {
  std::string_view text;
  source::Range range;
};

class Parser {
 public:
  Parser(const source::SourceManager& sources, const Settings& settings, diag::Engine& diagnostics)
      : sources_(sources), settings_(settings), diagnostics_(diagnostics) {}

  void ParseFile(source::FileId file);
  Program Take() { return std::move(program_); }

 private:
  // --- the project (parser.cc) ---
  std::vector<FilePart> SplitParts(const std::vector<Line>& lines);
  void ReadSizes(const std::vector<FilePart>& parts);
  void ParsePart(const FilePart& part);
  bool CheckVersion(const FilePart& part, const Line& directive, int32_t newest);

  // --- fields (fields.cc) ---
  static std::vector<Field> FieldsOf(std::string_view text, source::Range range);
  std::vector<Field> FieldsOf(const Line& line) { return FieldsOf(line.text, line.range); }
  /// Reports another count than `count`; `names` says what was expected.
  bool HasFields(const std::vector<Field>& fields, size_t count, const Line& line, std::string_view names);
  bool ReadNumber(const Field& field, std::string_view what, int32_t& into);
  bool ReadNumberIn(const Field& field, std::string_view what, int32_t low, int32_t high, int32_t& into);
  bool ReadIndex(const Field& field, std::string_view what, uint32_t count, uint32_t& into);
  /// "200/9", as elements, conditions and expressions have it; the place of what is wrong is `range`.
  bool ReadVariable(std::string_view text, source::Range range, Address& into);

  // --- lists (lists.cc) ---
  void ParsePresets(const FilePart& part, std::map<uint32_t, Preset>& into, uint32_t count, std::string_view what);
  void ParseExpressions(const FilePart& part);
  void ParseSections(const FilePart& part);
  void ParseSectionName(const Line& line);
  void ParseSection(const Line& line);
  void ParseSymbols(const FilePart& part);

  // --- rungs (rungs.cc) ---
  void ParseRung(const FilePart& part);
  void ParseDirective(const Line& line, Rung& rung);
  void ParseRow(const Line& line, Rung& rung);
  void ParseElement(const Field& field, uint32_t x, uint32_t y, Rung& rung);

  // --- sequential pages (sequential.cc) ---
  void ParseSequential(const FilePart& part);
  void ParseStep(const Line& line);
  void ParseTransition(const Line& line);
  void ParseCondition(const Line& line);
  bool ReadSteps(const std::vector<Field>& fields, size_t first, std::vector<uint32_t>& into);

  const source::SourceManager& sources_;
  const Settings& settings_;
  diag::Engine& diagnostics_;
  Program program_;
  std::map<uint32_t, std::string> section_names_;
  bool has_project_ = false;
  bool is_newer_ = false;  // than the engine: said
};

}  // namespace plcxx::classicladder
