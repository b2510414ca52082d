// Prints one generated .cpp file; what the pieces of the printing share. Only cpp_*.cc include this.
//
// cpp_routines.cc the file and its functions; cpp_statements.cc comments and instructions; cpp_control_flow.cc what
// owns regions and what leaves them; cpp_initial.cc the values at power-on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/emit/print/cpp_printer.h"

namespace plcxx::emit::print {

struct InitialArray;

/// The state of the printing is where it stands in the text.
class PartPrinter {
 public:
  PartPrinter(const Emittable& emittable, const source::SourceManager& sources, uint32_t part)
      : emittable_(emittable), program_(*emittable.program), sources_(sources), part_(part) {}

  std::string Run();
  /// Behind Run: the loops and owners with their lines.
  std::vector<PrintedLoop> LoopsIn(std::string_view text) const;
  std::vector<LineOwner> OwnersIn(std::string_view text) const;
  const LocalNames& locals() const { return local_names_; }

 private:
  // cpp_routines.cc
  void Includes();
  void Using();
  bool IsPrinted(ir::RoutineId id) const;
  std::vector<bool> CalledSubroutines() const;
  void Declarations(const std::vector<bool>& called);
  void Routines(const std::vector<bool>& called);
  std::string Linkage(ir::RoutineId id, const std::vector<bool>& called) const;
  void Routine(ir::RoutineId id, const std::vector<bool>& called);
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
  void Stretch(ir::RegionId region, uint32_t begin, uint32_t end);
  /// The debug flavour's: of a statement that may be switched off while others in its regions are not.
  void OpenStretch(ir::RegionId region, uint32_t begin, uint32_t end);
  bool HoldsOthers(const ir::Inst& inst) const;
  void Inst(ir::InstId id);
  void Comments(ir::InstId id);
  void Effect(ir::InstId id);
  void Store(ir::InstId id);
  void LoadRetentive(ir::InstId id);
  void Local(ir::InstId id);
  void StatementComments(const ir::Statement& statement);
  void Line(Text text);
  void Comment(std::string_view text);
  /// What follows in the text is the current statement's.
  void Own() { Own(statement_); }
  void Own(ir::StatementId statement);
  Text Value(uint32_t word) const { return Spell(emittable_, ir::ValueId(word)).text; }
  std::string On() const { return On(statement_); }
  std::string On(ir::StatementId statement) const;

  // cpp_control_flow.cc
  void If(ir::InstId id);
  /// The instruction that makes a chain of an else arm: an If whose condition needs no line of its own; or none.
  ir::InstId ChainedIf(ir::RegionId otherwise, ir::StatementId& statement) const;
  /// A condition, switched off together with its statement in the debug flavour.
  Text Condition(const ir::Inst& inst) const;
  void Switch(ir::InstId id);
  bool EndsElsewhere(ir::RegionId region) const;
  void Loop(ir::InstId id, const ir::Inst& inst);
  Spelling LoopCondition(const ir::Loop& loop, ir::StatementId statement) const;
  Text LoopHead(const ir::Loop& loop, const std::string& counter, const Text& condition) const;
  void BudgetLoop(const ir::Loop& loop, const Landing& labels);
  Text Step(ir::RegionId region) const;
  bool IsSpelledAsOne(ir::RegionId region) const;
  void Block(ir::InstId id, const ir::Inst& inst);
  void Exit(ir::InstId id, const ir::Inst& inst);
  void Repeat(ir::InstId id, const ir::Inst& inst);
  void Label(const std::string& label);
  bool EndsByLeaving(ir::RegionId region) const;
  std::string Departure(ir::InstId id) const;

  bool debug() const { return emittable_.options.flavour == Flavour::kDebug; }
  /// The debug flavour: what follows is not yet inside of `if (m.on(...))` of its statement, and has to be.
  bool Switchable() const;

  const Emittable& emittable_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  uint32_t part_;
  std::string out_;
  std::vector<Piece> function_;  // being printed
  bool uses_state_ = false;      // it has a parameter of that name
  SpelledEffects spelled_;       // by it
  std::string return_;           // "return;"
  size_t body_begin_ = 0;
  int indent_ = 0;
  LocalNames local_names_;     // of the functions printed so far
  ir::StatementId statement_;  // the one being printed
  struct LoopHeadAt {
    size_t offset = 0;
    ir::LoopId loop;
  };
  std::vector<LoopHeadAt> loops_;  // printed so far
  bool switched_ = false;          // inside of its `if (m.on(...))`
  struct Owner {
    size_t offset = 0;
    ir::StatementId statement;
  };
  std::vector<Owner> owners_;  // of the text from there on
};

}  // namespace plcxx::emit::print
