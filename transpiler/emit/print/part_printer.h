// Prints one generated .cpp file; what the pieces of the printing share. Only cpp_*.cc include this.
//
// cpp_routines.cc the file and its functions; cpp_statements.cc comments and instructions; cpp_control_flow.cc what
// owns regions and what leaves them; cpp_initial.cc the values at power-on.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/emit/initial_values.h"
#include "transpiler/emit/print/cpp_printer.h"

namespace plcxx::emit::print {

/// Text that grows, and the number of its last line.
class GrowingText {
 public:
  GrowingText& operator+=(std::string_view more) {
    text_ += more;
    line_ += static_cast<uint32_t>(std::count(more.begin(), more.end(), '\n'));
    return *this;
  }
  GrowingText& operator+=(char more) { return *this += std::string_view(&more, 1); }
  size_t size() const { return text_.size(); }
  uint32_t line() const { return line_; }
  std::string Take() { return std::move(text_); }

 private:
  std::string text_;
  uint32_t line_ = 1;
};

/// The state of the printing is where it is in the text.
class PartPrinter {
 public:
  PartPrinter(const Emittable& emittable, const source::SourceManager& sources, uint32_t part)
      : emittable_(emittable), program_(*emittable.program), sources_(sources), part_(part) {}

  OutputFile Run();

 private:
  // cpp_routines.cc
  void Includes();
  void Using();
  bool IsPrinted(ir::RoutineId id) const;
  bool Calls(ir::RoutineId id) const { return emittable_.parts[part_].called[id.index]; }
  void Declarations();
  void Routines();
  std::string Linkage(ir::RoutineId id) const;
  void Routine(ir::RoutineId id);
  void PrintChunk(const Chunk& chunk);
  void Runs();
  std::string Arguments(const Locals& locals) const;
  std::string Prototype(const std::string& head, const Locals& locals) const;
  void OpenFunction(const std::string& head, const Locals& locals, std::vector<Piece> pieces);
  void CloseFunction();

  // cpp_initial.cc
  void InitStorage();
  void InitialTable(layout::Storage storage, const InitialArray& array, uint32_t begin, uint32_t end);

  // cpp_statements.cc
  void RegionBody(ir::RegionId region);
  void Range(ir::RegionId region, uint32_t begin, uint32_t end);
  /// Instructions without markers among them.
  void Segment(ir::RegionId region, uint32_t begin, uint32_t end);
  void Inst(ir::InstId id);
  void Comments(ir::InstId id);
  void Effect(ir::InstId id);
  void Store(ir::InstId id);
  void LoadRetentive(ir::InstId id);
  void Local(ir::InstId id);
  void StatementComments(const ir::Statement& statement);
  void Line(Text text);
  void BlankLine();
  void Comment(std::string_view text);
  void CommentLines(std::string_view text);
  /// What follows in the text is the current statement's.
  void Own() { Own(statement_); }
  void Own(ir::StatementId statement);
  Text Value(uint32_t word) const { return Spell(emittable_, ir::ValueId(word)).text; }
  const Switch* SwitchOf(ir::InstId id) const;
  std::string On(ir::StatementId statement) const;

  // cpp_control_flow.cc
  void If(ir::InstId id);
  Text Condition(ir::InstId id) const;
  void SwitchOver(ir::InstId id);
  void Loop(ir::InstId id, const ir::Inst& inst);
  Text LoopHead(const ir::Loop& loop, const std::string& counter, const Text& condition) const;
  void BudgetLoop(const ir::Loop& loop, const Landing& labels);
  Text Step(ir::RegionId region) const;
  void Block(ir::InstId id, const ir::Inst& inst);
  void Exit(ir::InstId id, const ir::Inst& inst);
  void Repeat(ir::InstId id, const ir::Inst& inst);
  void Label(const std::string& label);
  std::string Word(Leave leave) const;
  std::string Departure(ir::InstId id) const;

  bool debug() const { return emittable_.options.flavour == Flavour::kDebug; }

  const Emittable& emittable_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  uint32_t part_;
  GrowingText out_;
  enum class Last : uint8_t { kText, kLabel, kBlank };
  Last last_ = Last::kText;      // line of the text
  std::vector<Piece> function_;  // being printed
  bool uses_state_ = false;      // it has a parameter of that name
  SpelledEffects spelled_;       // by it
  std::string return_;           // "return;"
  size_t body_begin_ = 0;
  int indent_ = 0;
  ir::StatementId statement_;  // the one being printed
  std::vector<PrintedLoop> loops_;
  std::vector<LineOwner> owners_;
  LocalNames local_names_;
};

}  // namespace plcxx::emit::print
