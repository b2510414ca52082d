// Clang's diagnostics as findings of our catalogue (specification 10.2): codes and words are ours, the places Clang's.
#pragma once

#include <clang/Basic/Diagnostic.h>

#include <cstdint>
#include <set>
#include <string>

#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {

class Diagnoser : public clang::DiagnosticConsumer {
 public:
  explicit Diagnoser(Session& session) : session_(session) {}

  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override;

 private:
  bool ByTable(const clang::Diagnostic& info);
  bool Calls(const clang::Diagnostic& info);
  bool Operands(const clang::Diagnostic& info);
  bool Conversions(const clang::Diagnostic& info);
  void Syntax(const clang::Diagnostic& info);
  bool HasUnterminated() const;
  bool ManualNotation(source::Range range, const std::string& name);
  bool MacroWithParameters(source::Range range, const std::string& name);
  bool IsFirstUse(source::Range range, const std::string& name);
  bool MacroOfBadForm(source::Range range, const std::string& token);
  bool Unfinished(const clang::Diagnostic& info);
  void ReportNoPointer(const clang::Diagnostic& info);
  bool LabelWithSemicolon(const clang::Diagnostic& info);
  void NoteMissingSemicolon(const clang::Diagnostic& info);
  bool ReportMeant(source::Range range, const std::string& token);
  bool IndexedNotation(source::Range range);
  std::string LineBefore(source::Offset place) const;
  std::string LineAfter(source::Offset place) const;
  std::string AreaAmong(const clang::Diagnostic& info) const;
  /// `byte b;`: the name after a word that is no type; empty: there is none.
  std::string NameAfter(source::Offset place) const;
  /// The name in reach that is most like this one; empty: none is.
  std::string NearDeclared(const std::string& name);
  bool NamesVariable(const clang::Diagnostic& info) const;
  void AcceptOverflow(const clang::Diagnostic& info);
  void AddNote(const clang::Diagnostic& info);

  source::Range RangeOf(const clang::Diagnostic& info) const;
  std::string TokenAt(source::Range range) const;
  std::string Written(source::Range range) const { return session_.input.text(range); }

  Session& session_;
  std::set<std::string> mistyped_;                                   // names whose declarations have no type
  std::set<std::pair<const clang::Decl*, std::string>> undeclared_;  // in which function
  bool unclosed_call_ = false;  // of a macro: the rest of the file are its arguments
  uint32_t near_searches_ = 0;
  uint32_t errors_ = 0;              // of the parser
  source::Range folded_size_;        // of an array, where the last diagnostic was of that
  bool is_folded_ = false;           // the last finding is of what Clang can compute all the same
  bool reported_last_ = false;       // a note belongs to the last finding
  bool last_is_in_product_ = false;  // where its header disagrees with what the program says of a name before
};

std::string Quoted(const std::string& text);

/// An argument of a diagnostic as text without quotes: a name, a type, a token, a number; empty where there is none.
std::string ArgumentText(const clang::Diagnostic& info, unsigned index);

}  // namespace plcxx::hnc
