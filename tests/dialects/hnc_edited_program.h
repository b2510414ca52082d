// A program of hnc as an editor changes it: after each change the tree and the messages of a run that takes over what
// it can, and of one that has nothing to take over.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/dialects/hnc_parsing.h"
#include "tests/temporary_directory.h"
#include "transpiler/dialects/hnc/parser/kept_program.h"

namespace plcxx::hnc {

/// Everything in a tree, with places as places in files: numbers of places differ between runs that read more files.
class TreeText {
 public:
  TreeText(const source::SourceManager& sources, const Unit& unit) : sources_(sources), unit_(unit) {}

  std::string Run() {
    for (const Type& type : unit_.types) Put(type);
    for (const Record& record : unit_.records) Put(record);
    for (const Variable& variable : unit_.variables) Put(variable);
    for (const Function& function : unit_.functions) Put(function);
    for (const Label& label : unit_.labels) {
      Line("label") << label.name << At(label.range) << ' ' << label.statement.index << label.used;
    }
    for (const Expr& expr : unit_.expressions) Put(expr);
    for (const Statement& statement : unit_.statements) Put(statement);
    for (const Macro& macro : unit_.macros) {
      Line("macro") << macro.name << At(macro.range) << macro.has_parameters << macro.is_system;
    }
    for (const MacroUse& use : unit_.macro_uses) Line("use") << use.macro.index << At(use.range);
    for (const std::string& string : unit_.strings) Line("string") << string;
    for (const Comment& comment : unit_.comments) Line("comment") << At(comment.range) << comment.text;
    Line("definitions") << Ids(unit_.definitions) << ' ' << unit_.init.index << ' ' << unit_.plc1.index << ' '
                        << unit_.plc2.index << At(unit_.last_token) << ' ' << unit_.line_count << ' '
                        << unit_.statement_count << ' ' << unit_.char_is_signed << unit_.faulty;
    return out_.str();
  }

 private:
  std::ostream& Line(const char* kind) { return out_ << '\n' << kind << ' '; }
  std::string At(source::Offset place) const {
    const source::FileId file = sources_.FileAt(place);
    if (place == 0 || !file.valid()) return " none";
    const source::File& found = sources_.Get(file);
    return " " + found.path + ":" + std::to_string(place - found.base);
  }
  std::string At(source::Range range) const { return At(range.begin) + " to" + At(range.end); }
  template <class List>
  static std::string Ids(const List& ids) {
    std::string text = " (";
    for (const auto id : ids) text += std::to_string(id.index) + " ";
    return text + ")";
  }

  void Put(const Type& type) {
    Line("type") << static_cast<int>(type.kind) << ' ' << int{type.bits} << type.is_signed << ' ' << type.element.index
                 << ' ' << type.count << ' ' << type.record.index << ' ' << type.size << ' ' << type.text;
  }
  void Put(const Record& record) {
    Line("record") << record.name << record.is_union << ' ' << record.size << At(record.range);
    for (const Member& member : record.members) {
      Line("  member") << member.name << ' ' << member.type.index << ' ' << member.offset << ' ' << member.is_bit_field
                       << int{member.bit_offset} << ' ' << int{member.bit_width} << At(member.range);
    }
  }
  void Put(const Variable& variable) {
    Line("variable") << variable.name << ' ' << variable.type.index << ' ' << static_cast<int>(variable.storage)
                     << variable.is_static << variable.is_const << variable.is_register << variable.initialised << ' '
                     << variable.function.index << At(variable.range);
    for (const InitialValue& value : variable.initial) {
      Line("  initial") << value.offset << ' ' << value.is_bit_field << int{value.bit_offset} << ' '
                        << int{value.bit_width} << ' ' << value.type.index << ' ' << value.value.index;
    }
    if (variable.view) {
      Line("  view") << static_cast<int>(variable.view->area) << variable.view->table << ' '
                     << variable.view->element.index << ' ' << variable.view->count;
    }
  }
  void Put(const Function& function) {
    Line("function") << function.name << ' ' << function.result.index << Ids(function.parameters)
                     << Ids(function.parameter_types) << Ids(function.locals) << Ids(function.labels)
                     << function.is_static << function.is_defined << function.has_prototype << ' '
                     << (function.system ? static_cast<int>(*function.system) : -1) << ' ' << function.body.index
                     << At(function.range) << At(function.head);
  }
  void Put(const Expr& expr) {
    Line("expression") << static_cast<int>(expr.kind) << ' ' << static_cast<int>(expr.unary) << ' '
                       << static_cast<int>(expr.binary) << ' ' << static_cast<int>(expr.increment) << ' '
                       << expr.is_lvalue << expr.is_implicit << expr.parenthesized << expr.whole_macro << ' '
                       << expr.type.index << ' ' << expr.computation.index << At(expr.range) << At(expr.op) << ' '
                       << expr.a.index << ' ' << expr.b.index << ' ' << expr.c.index << Ids(expr.arguments)
                       << expr.variable.index << ' ' << expr.function.index << ' ' << expr.member << ' ' << expr.string
                       << ' ' << expr.macro.index;
    if (expr.constant) out_ << " = " << expr.constant->integer << ' ' << expr.constant->real;
  }
  void Put(const Statement& statement) {
    Line("statement") << static_cast<int>(statement.kind) << ' ' << statement.expression.index << ' '
                      << statement.first.index << ' ' << statement.step.index << ' ' << statement.then.index << ' '
                      << statement.otherwise.index << Ids(statement.body) << Ids(statement.variables)
                      << statement.label.index << ' ' << statement.value << ' ' << statement.case_expression.index
                      << At(statement.range) << At(statement.head) << At(statement.keyword) << At(statement.close)
                      << At(statement.otherwise_keyword) << ' ' << statement.macro.index;
    if (statement.loop_bound) out_ << " bound " << statement.loop_bound->rounds << At(statement.loop_bound->range);
  }

  const source::SourceManager& sources_;
  const Unit& unit_;
  std::ostringstream out_;
};

using Texts = std::map<std::string, std::string>;  // by name; the main source is "main.cld"

/// A program in a folder of its own, as an editor changes it.
class EditedProgram {
 public:
  explicit EditedProgram(Texts texts) : texts_(std::move(texts)) {}

  const Texts& texts() const { return texts_; }
  void Set(const std::string& name, std::string text) { texts_[name] = std::move(text); }
  /// How many bodies the last run has taken over.
  uint32_t taken_over() const { return taken_over_; }

  /// Empty: it is as a run that takes nothing over; else where they differ.
  std::string Difference() {
    for (const auto& [name, text] : texts_) {
      directory_.Write(name, text);
    }
    const std::string found = Read(&kept_);
    const auto* program = dynamic_cast<const KeptProgram*>(kept_.get());
    taken_over_ = program == nullptr ? 0 : program->taken_over;
    const std::string expected = Read(nullptr);
    if (found == expected) return {};
    const auto at = std::mismatch(found.begin(), found.end(), expected.begin(), expected.end());
    const auto before = static_cast<size_t>(at.first - found.begin());
    const size_t begin = before < 300 ? 0 : before - 300;
    return "taken over:\n" + found.substr(begin, 600) + "\n\nread again:\n" + expected.substr(begin, 600);
  }

 private:
  std::string Read(std::unique_ptr<dialects::Kept>* kept) {
    Parsed parsed;
    const auto loaded = parsed.sources.Load(directory_.File("main.cld"), LoadOptionsOf(std::nullopt));
    const auto* file = std::get_if<source::FileId>(&loaded);
    if (file == nullptr) return "not to be read";
    dialects::Request request;
    request.sources = &parsed.sources;
    request.files = {*file};
    request.diagnostics = &parsed.diagnostics;
    request.kept = kept;
    Unit unit = Parse(request);
    std::string text = TreeText(parsed.sources, unit).Run();
    Keep(request, std::move(unit));
    for (const diag::Diagnostic& diagnostic : parsed.diagnostics.all()) {
      const source::Position at = parsed.sources.Locate(diagnostic.range.begin);
      text += "\n" + std::to_string(at.line) + ":" + std::to_string(at.column) + " " +
              std::to_string(diagnostic.range.end - diagnostic.range.begin) + " " + std::string(diagnostic.row->code) +
              " " + diagnostic.text;
      if (at.file.valid()) text += " " + parsed.sources.Get(at.file).path;
      for (const diag::Note& note : diagnostic.notes) {
        const source::Position place = parsed.sources.Locate(note.range.begin);
        text += "\n  " + std::to_string(place.line) + ":" + std::to_string(place.column) + " " + note.text;
      }
      for (const diag::FixIt& fixit : diagnostic.fixits) text += "\n  " + fixit.replacement;
    }
    return text;
  }

  testing_support::TemporaryDirectory directory_;
  Texts texts_;
  std::unique_ptr<dialects::Kept> kept_;
  uint32_t taken_over_ = 0;
};

}  // namespace plcxx::hnc
