// What all parts of the parser share: the program being made, its names, and where messages go. Shared by its files
// only.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/common/fault_reporter.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/parser/symbol_table.h"
#include "transpiler/dialects/technol/source/lexer.h"
#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

class ParsingContext : private dialects::FaultReporter {
 public:
  ParsingContext(const source::SourceManager& all_sources, diag::Engine& engine, const Settings& options)
      : FaultReporter(engine, faulty),
        sources(all_sources),
        diagnostics(engine),
        settings(options),
        names(program.symbols, options.names) {}
  ParsingContext(const ParsingContext&) = delete;
  ParsingContext& operator=(const ParsingContext&) = delete;

  /// What is reported from now on belongs to statement `number`, which is located in `in` (none: in a file). Statements
  /// are numbered in the order of the text.
  void BeginStatement(uint32_t number, ExpansionId in) {
    statement = number;
    expansion = in;
    faulty = false;
  }
  void NextStatement(ExpansionId in) { BeginStatement(statement + 1, in); }

  /// A statement that is in error gives no further errors (10.5).
  template <class... Args, class... Values>
  diag::Diagnostic& Report(source::Range range, const diag::Message<Args...>& message, Values&&... values) {
    const bool is_fault = message.row.severity == diag::Severity::kError;
    diag::Diagnostic& diagnostic = is_fault ? Fault(range, message, std::forward<Values>(values)...)
                                            : diagnostics.Report(range, message, std::forward<Values>(values)...);
    AddNotes(diagnostic, program, expansion);
    return diagnostic;
  }

  /// The statement says nothing more: its cause has been reported elsewhere.
  void Forgive() { faulty = true; }
  /// The faulty statement may be what defines `name`: that it is undefined follows from the fault.
  void Excuse(std::string_view name) { excused_.insert(names.Fold(name)); }
  bool IsExcused(std::string_view name) const { return excused_.contains(names.Fold(name)); }

  /// The reserved word has been reported as a name: its uses are no errors of their own.
  bool IsReportedAsName(std::string_view word) const { return reserved_.contains(word); }
  /// An undefined name, once for each name.
  void ReportUndefined(std::string_view name, source::Range range);
  /// Once for each word that was to be a name. `behind`: the text of the next token, where the word may be meant with
  /// it.
  void ReportReserved(const Token& token, std::string_view behind);
  /// At most 31 characters (TE003), reported once for each name.
  bool IsShort(const Token& token);
  /// A name may be defined by the statement: length and reserved words (2.3). Reports.
  bool IsName(const Token& token);
  /// Reports a name that is taken; false when it is free.
  bool IsTaken(const Token& name);
  /// Defines a name that may be defined; not valid when it may not (reported).
  SymbolId Define(const Token& name, Symbol symbol);

  const source::SourceManager& sources;
  diag::Engine& diagnostics;
  const Settings& settings;
  Program program;
  SymbolTable names;
  uint32_t statement = 0;
  ExpansionId expansion;
  bool faulty = false;

 private:
  /// The name of the program or the control that is spelled nearly so; empty when none is.
  std::string NearName(std::string_view name);

  uint32_t near_searches_ = 0;
  std::set<std::string, std::less<>> undefined_, excused_, too_long_, reserved_;
};

/// "'X'", or "the end of the line": a token for messages.
std::string Shown(const Token* token);

}  // namespace plcxx::technol
