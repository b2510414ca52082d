// Heads of sections and networks, and which lines belong to a network (specification 3.2, 3.3).
#pragma once

#include <optional>
#include <vector>

#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"

namespace plcxx::host50 {

class SectionReader : private StatementReader {
 public:
  SectionReader(Parsing& parsing, Parts& parts) : StatementReader(parsing), parts_(parts) {}

  /// A comment above the next part.
  void AddComment(source::Range comment) { comments_.push_back(comment); }
  void ForgetComments() { comments_.clear(); }
  /// The comments above a line and its own.
  Span TakeComments(const Line& line) { return AddComments(comments_, line.comment); }
  /// Those behind the last part of a file, to those at the end of its last section.
  void AddEndComments(SectionId section);

  /// At the line that opens it.
  SectionId OpenSection(PartKind part, const Line& line);
  /// Networks and instructions that no section has.
  SectionId OpenStraySection(const Line& line);
  /// `line` of the file is number `number`.
  void OpenNetwork(SectionId section, const Line& line, uint32_t number);
  /// Instructions where no NETWORK was written are read all the same, from line `first` on; the first one is reported.
  void OpenStrayNetwork(SectionId section, const Line& line, uint32_t first);
  void TakeBodyLine(SectionId section, Line& line, uint32_t number);
  /// E311 when a drawing is open.
  void CloseLadder();
  /// The network that is open ends in front of line `end`.
  void CloseBody(uint32_t end);

 private:
  void CheckSection(SectionId id);
  void ReadNetworkHead(Network& network);
  void CheckNetwork(SectionId section, NetworkId id);

  Parts& parts_;
  std::vector<source::Range> comments_;       // above the next part
  std::optional<source::Range> open_ladder_;  // its opening line
  uint32_t program_count_ = 0, network_count_ = 0;
  bool programs_reported_ = false, networks_reported_ = false;
};

}  // namespace plcxx::host50
