// MOD and END (specification 4.1, recovery of section 10).
#pragma once

#include <optional>
#include <set>
#include <string>

#include "transpiler/dialects/prostep/parser/comment_reader.h"
#include "transpiler/dialects/prostep/parser/instruction_reader.h"
#include "transpiler/dialects/prostep/parser/label_reader.h"
#include "transpiler/dialects/prostep/parser/line_reader.h"
#include "transpiler/dialects/prostep/parser/operand_reader.h"

namespace plcxx::prostep {

class ModuleReader : private LineReader {
 public:
  ModuleReader(Parsing& parsing, CommentReader& comments, LabelReader& labels, OperandReader& operands,
               InstructionReader& instructions, BracketChecker& brackets)
      : LineReader(parsing),
        comments_(comments),
        labels_(labels),
        operands_(operands),
        instructions_(instructions),
        brackets_(brackets) {}

  void OpenModule(const Statement& statement);
  void CloseModule(const Statement& statement);
  void EndFile();
  /// What stands outside has its cause in a module within a module, or has been reported: one missing MOD is one error,
  /// whatever the length of its module and with its END.
  bool is_forgiving() const { return forgiving_ || outside_; }
  void BeginOutside() { outside_ = true; }

 private:
  /// The number after MOD or END; none when it is wrong (reported).
  std::optional<uint32_t> ModuleNumber(const Statement& statement);
  std::optional<uint32_t> ClosedNumber(const Statement& statement);
  void LeaveModule(source::Range close);

  CommentReader& comments_;
  LabelReader& labels_;
  OperandReader& operands_;
  InstructionReader& instructions_;
  BracketChecker& brackets_;
  std::string faulty_module_;  // the operand of a MOD whose number is wrong
  bool forgiving_ = false;
  bool twice_ = false;            // reported: what MOD names is another module's number
  bool outside_ = false;          // reported: until the next MOD or END
  std::set<uint32_t> abandoned_;  // numbers of modules that an inner MOD closed and that wait for their END
};

}  // namespace plcxx::prostep
