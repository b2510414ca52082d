// The HELP file: the machine builder's own descriptions of signals (specification 9.6).
#pragma once

#include <map>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

struct HelpEntry {
  std::string name;  // "RESE"
  std::string text;  // lines joined by a line end
};

/// By address, I and U alike.
class HelpTexts {
 public:
  const HelpEntry* Find(const Operand& operand) const;
  bool Describes(const Operand& operand) const { return Find(operand) != nullptr; }
  void Add(const Operand& operand, HelpEntry entry);

 private:
  std::map<std::string, HelpEntry> entries_;
};

/// Malformed entries are W363 and left out.
HelpTexts ReadHelpFile(const source::SourceManager& sources, source::FileId file, diag::Engine& diagnostics);

}  // namespace plcxx::nc110
