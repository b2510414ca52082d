// Modules, mechanisms, data blocks and STOP (specification 4.1, 4.2): what is open, and where it ends.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "transpiler/dialects/technol/parser/code_reader.h"
#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

class UnitReader : private StatementReader {
 public:
  UnitReader(Parsing& parsing, CommentReader& comments, CodeReader& code)
      : StatementReader(parsing), last_source_(parsing.last_source), comments_(comments), code_(code) {}

  void BeginSource() { stopped_ = false; }
  void OpenModule(const Statement& statement, ModuleKind kind);
  void CloseModule(const Statement& statement, std::string_view keyword);
  void OpenMechanism(const Statement& statement);
  void CloseMechanism(const Statement& statement);
  void OpenData(const Statement& statement);
  void CloseData(const Statement& statement);
  void ReadStop(const Statement& statement);
  void ReadInstruction(const Statement& statement, Op op);
  /// Lines after STOP are not read; the first one is reported.
  bool IsAfterStop(source::Range line);
  /// `last`: the last line of the file.
  void EndOfSource(source::Range last);
  /// What the program lacks as a whole; `last`: its last line.
  void CheckWhole(source::Range last);

 private:
  void LeaveModule(source::Range close);
  void BeginMechanism(const Statement& statement, const Token* name);
  void LeaveMechanism(source::Range close);
  /// A mechanism that is open lacks its end, which is reported at `place`.
  void LeaveOpenMechanism(source::Range place);

  const source::FileId& last_source_;
  CommentReader& comments_;
  CodeReader& code_;
  bool has_data_ = false;
  bool has_stop_ = false;
  bool stopped_ = false;
  bool warned_after_stop_ = false;
  std::set<std::string> abandoned_modules_, abandoned_mechanisms_;  // closed by an inner one, their END may come
  std::map<std::string, source::Range> modules_;                    // where each is opened first
};

}  // namespace plcxx::technol
