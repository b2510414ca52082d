// The parts of all files: sections with their networks, tables, directives (specification 3.2, 3.3, 9).
#pragma once

#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/section_reader.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"

namespace plcxx::host50 {

class StructureReader : private StatementReader {
 public:
  explicit StructureReader(Parsing& parsing) : StatementReader(parsing), sections_(parsing, parts_) {}
  StructureReader(const StructureReader&) = delete;
  StructureReader& operator=(const StructureReader&) = delete;

  Parts ReadStructure();

 private:
  void ReadTopLevelLine();
  bool IsSymbolRow(const Line& line) const;
  bool ReadRowsWithoutSymbols();
  void ReadTable(PartKind part);
  void ReadSection(PartKind part);
  /// The line of the END that is met first, before any other part begins.
  std::optional<uint32_t> NextEnd() const;
  void ForgetCommentsOfTable();
  /// At a word that is nearly the opening word of the part that is closed next: E101, and the part begins.
  bool ReadMisspeltOpening();
  /// Networks and instructions outside of any section, up to the next part.
  void ReadStray();
  /// At an END word that does not close `part`: E312. True when it is taken for the one that is missing.
  bool ReadWrongEnd(PartKind part);
  /// At a word that is nearly the END word of `part`, which is not there otherwise: E101, and the part ends.
  bool ReadMisspeltEnd(PartKind part);
  /// Is `part` still closed before the next part begins?
  bool EndsLater(PartKind part);
  /// END_x alone on its line.
  void ReadEnd();
  void ReportDirectiveInside(PartKind part);
  /// No more lines, or a part begins.
  bool AtNextPart();
  Line& CurrentLine() { return files_[now_.file].lines[line_]; }
  bool AtEndOfFile() const { return line_ >= files_[now_.file].lines.size(); }

  Parts parts_;
  SectionReader sections_;
  uint32_t line_ = 0;
  std::optional<SectionId> last_section_;  // of the file; none: it has had none yet
  /// From each line in [from, line) of the file the first line that begins a part or ends this one is `line`.
  struct Ahead {
    uint32_t file = 0;
    PartKind part = PartKind::kTitle;
    uint32_t from = 0, line = 0;
    bool ends = false;  // it ends this one
  };
  Ahead ahead_;
};

}  // namespace plcxx::host50
