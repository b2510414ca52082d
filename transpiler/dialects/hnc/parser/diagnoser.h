// Clang's diagnostics as findings of our catalogue (specification 10.2): codes and words are ours, the places Clang's.
#pragma once

#include <clang/Basic/Diagnostic.h>

#include <string>

#include "transpiler/dialects/hnc/parser/session.h"

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
  bool ManualNotation(source::Range range, const std::string& name);
  void AddNote(const clang::Diagnostic& info);

  source::Range RangeOf(const clang::Diagnostic& info) const;
  std::string TokenAt(source::Range range) const;
  std::string Written(source::Range range) const { return session_.input.text(range); }

  Session& session_;
  source::Range folded_size_;   // of an array, where the last diagnostic was of that
  bool reported_last_ = false;  // a note belongs to the last finding
};

/// An argument of a diagnostic as text without quotes: a name, a type, a token, a number; empty where there is none.
std::string ArgumentText(const clang::Diagnostic& info, unsigned index);

}  // namespace plcxx::hnc
