// The parts of the sources: sections with their networks, tables, directives (specification 3.2, 3.3, 9).
#include "transpiler/dialects/host50/parser/internal.h"

namespace plcxx::host50 {
namespace {

constexpr std::string_view kNetwork = "NETWORK";
constexpr std::string_view kDirectives[] = {"SLOWDIV", "CHANNELS", "OPTION"};

bool IsSection(PartKind part) { return part == PartKind::kFast || part == PartKind::kSlow || part == PartKind::kSub; }

SectionKind SectionOf(PartKind part) {
  switch (part) {
    case PartKind::kFast:
      return SectionKind::kFast;
    case PartKind::kSlow:
      return SectionKind::kSlow;
    case PartKind::kSub:
      return SectionKind::kSubroutine;
    case PartKind::kTitle:
    case PartKind::kSymbols:
    case PartKind::kAlarms:
    case PartKind::kMCodes:
    case PartKind::kLadder:
      return SectionKind::kNone;
  }
  PLCXX_UNREACHABLE();
}

/// A part that begins at top level.
std::optional<PartKind> Opener(std::string_view word) {
  const auto part = PartByName(word);
  return part == PartKind::kLadder ? std::nullopt : part;
}

}  // namespace

void Parser::ReadStructure() {
  for (file_ = 0; file_ < files_.size(); ++file_) {
    EnterFile(files_[file_]);
    comments_.clear();
    for (line_ = 0; line_ < files_[file_].lines.size();) ReadTopLevelLine(file_);
  }
}

bool Parser::IsDirective(std::string_view word) const {
  for (const std::string_view directive : kDirectives) {
    if (EqualIgnoringCase(directive, word)) return true;
  }
  return false;
}

/// The comments above a line and its own.
Span Parser::TakeComments(const Line& line) { return AddComments(comments_, line.comment); }

void Parser::ReadTopLevelLine(uint32_t file) {
  Line& line = CurrentLine();
  if (line.kind == LineKind::kBlank || line.kind == LineKind::kComment) {
    if (line.kind == LineKind::kComment) comments_.push_back(line.comment);
    ++line_;
    return;
  }
  const std::string_view word = WordOf(line);
  if (const auto part = Opener(word)) {
    IsSection(*part) ? ReadSection(*part, file) : ReadTable(*part, file);
  } else if (IsDirective(word)) {
    comments_.clear();
    directives_.push_back({file, line_++});
  } else if (PartByEnd(word)) {
    Begin(line);
    Fault(Peek().range, diag::Host50UnexpectedEnd, word, "closes nothing");
    comments_.clear();
    ++line_;
  } else {
    ReadStray(file);
  }
}

void Parser::ReadTable(PartKind part, uint32_t file) {
  comments_.clear();
  const source::Range opening = CurrentLine().range;
  Begin(CurrentLine());
  Take();
  ExpectEnd();
  Table table{.part = part, .file = file, .first = ++line_};
  for (bool open = true; open; ++line_) {
    if (line_ >= files_[file].lines.size() || Opener(WordOf(CurrentLine()))) {
      Report(opening, diag::Host50MissingEnd, Name(part));
      break;
    }
    Line& line = CurrentLine();
    const std::string_view word = WordOf(line);
    const auto end = PartByEnd(word);
    if (end) line.consumed = true;
    if (end == part) {
      ReadEnd();
      open = false;
    } else if (end) {
      open = !ReadWrongEnd(part);
    } else if (IsDirective(word)) {
      ReportDirectiveInside(part);
    }
  }
  table.last = line_;
  tables_.push_back(table);
}

/// END_x alone on its line.
void Parser::ReadEnd() {
  Begin(CurrentLine());
  Take();
  ExpectEnd();
}

void Parser::ReportDirectiveInside(PartKind part) {
  CurrentLine().consumed = true;
  Begin(CurrentLine());
  std::string word(TextOf(Peek()));
  for (char& c : word) c = Upper(c);
  Fault(Peek().range, diag::Host50DirectiveInside, word, Name(part));
}

/// Is `part` still closed before the next part begins? What was found once holds up to there: thousands of wrong ends
/// would each look through the rest of the file.
bool Parser::EndsLater(PartKind part) {
  if (ahead_.file == file_ && ahead_.part == part && ahead_.from <= line_ && line_ < ahead_.line) return ahead_.ends;
  const LexedFile& file = files_[file_];
  ahead_ = {file_, part, line_, line_ + 1, false};
  for (; ahead_.line < file.lines.size(); ++ahead_.line) {
    const std::string_view word = WordOf(file.lines[ahead_.line]);
    ahead_.ends = PartByEnd(word) == part;
    if (ahead_.ends || Opener(word)) break;
  }
  return ahead_.ends;
}

bool Parser::ReadWrongEnd(PartKind part) {
  Begin(CurrentLine());
  const std::string open = "does not close " + std::string(Name(part));
  Fault(Peek().range, diag::Host50UnexpectedEnd, TextOf(Peek()), open);
  return !EndsLater(part);
}

void Parser::ReadSection(PartKind part, uint32_t file) {
  const source::Range opening = CurrentLine().range;
  const SectionId id = OpenSection(part);
  ++line_;
  for (bool open = true; open; ++line_) {
    if (line_ >= files_[file].lines.size() || Opener(WordOf(CurrentLine()))) {
      CloseBody();
      Report(opening, diag::Host50MissingEnd, Name(part));
      break;
    }
    Line& line = CurrentLine();
    const std::string_view word = WordOf(line);
    const auto end = PartByEnd(word);
    if (end == part) {
      CloseBody();
      program_.sections[id].end_comments = TakeComments(line);
      ReadEnd();
      open = false;
    } else if (end && end != PartKind::kLadder) {
      CloseLadder();
      line.consumed = true;
      open = !ReadWrongEnd(part);
      if (!open) CloseBody();
    } else if (IsDirective(word)) {
      ReportDirectiveInside(part);
    } else if (EqualIgnoringCase(word, kNetwork)) {
      CloseBody();
      OpenNetwork(id, file);
    } else {
      TakeBodyLine(id, file);
    }
  }
}

/// The network that is open ends in front of the current line.
void Parser::CloseBody() {
  CloseLadder();
  if (!bodies_.empty() && bodies_.back().last == 0) bodies_.back().last = line_;
}

SectionId Parser::OpenSection(PartKind part) {
  const Line& line = CurrentLine();
  Section section;
  section.kind = SectionOf(part);
  section.comments = TakeComments(line);
  section.range = line.range;
  section.networks.first = program_.networks.size();
  Begin(line);
  section.keyword = Take().range;
  if (part == PartKind::kSub) {
    const Token name = Peek();
    const auto number = name.kind == TokenKind::kWord ? NumberBehind("SR", TextOf(name)) : std::nullopt;
    section.number = number.value_or(kNoNumber);
    if (At(TokenKind::kEnd) || IsBad(name.kind)) {
      FaultOfMissing("the name of the subroutine");
    } else if (!number) {
      Fault(name.range, diag::Host50SubroutineNameExpected, Found());
    } else if (*number > kGreatestLabel) {
      section.number = kNoNumber;
      Fault(name.range, diag::Host50LabelRange, TextOf(name));
    }
    Take();
  }
  if (At(TokenKind::kString)) {
    section.name_range = Peek().range;
    section.name = StringOf(Take());
  }
  ExpectEnd();
  const SectionId id = program_.sections.Add(std::move(section));
  CheckSection(id);
  return id;
}

void Parser::CheckSection(SectionId id) {
  Section& section = program_.sections[id];
  if (section.kind != SectionKind::kSubroutine) {
    section.duplicate = FindSection(program_, section.kind) != id;
    if (section.duplicate) Fault(section.keyword, diag::Host50DuplicateSection, TextOf(section.keyword));
  } else if (section.number != kNoNumber) {
    section.duplicate = !subroutines_.emplace(section.number, id).second;
    if (section.duplicate) Fault(section.range, diag::Host50DuplicateSubroutine, SubroutineName(section.number));
  }
  if (++program_count_ > Available(Resource::kPrograms) && !std::exchange(programs_reported_, true)) {
    Fault(section.range, diag::Host50TooManyPrograms);
  }
}

void Parser::OpenNetwork(SectionId section, uint32_t file) {
  const Line& line = CurrentLine();
  Network network;
  network.section = section;
  network.comments = TakeComments(line);
  network.range = line.range;
  network.number = program_.sections[section].networks.count;
  Begin(line);
  ReadNetworkHead(network);
  const NetworkId id = program_.networks.Add(std::move(network));
  ++program_.sections[section].networks.count;
  CheckNetwork(section, id);
  bodies_.push_back({.network = id, .file = file, .first = line_ + 1});
}

void Parser::ReadNetworkHead(Network& network) {
  network.keyword = Take().range;
  if (At(TokenKind::kWord)) {
    const Token label = Peek();
    const auto number = NumberBehind("L", TextOf(label));
    if (!number) {
      Fault(label.range, diag::Host50LabelExpected, Found());
    } else if (*number > kGreatestLabel) {
      Fault(label.range, diag::Host50LabelRange, TextOf(label));
    } else {
      network.has_label = true;
      network.number = *number;
    }
    Take();
  }
  if (At(TokenKind::kString)) network.comment = StringOf(Take());
  ExpectEnd();
}

void Parser::CheckNetwork(SectionId section, NetworkId id) {
  const Network& network = program_.networks[id];
  if (!failed_ || network.has_label) {  // a label that could not be read has no number
    if (!labels_.emplace(std::pair(section, network.number), id).second) {
      Fault(network.range, diag::Host50DuplicateNetwork, "L" + std::to_string(network.number));
    }
  }
  const bool in_fast = program_.sections[section].kind == SectionKind::kFast;
  if (in_fast && program_.sections[section].networks.count == kMostFastNetworks + 1) {
    Fault(network.range, diag::Host50FastNetworks);
  }
  if (++network_count_ > Available(Resource::kNetworks) && !std::exchange(networks_reported_, true)) {
    Fault(network.range, diag::Host50TooManyNetworks);
  }
}

/// Instructions where no NETWORK was written are read all the same; the first one is reported.
void Parser::OpenStrayNetwork(SectionId section, uint32_t file) {
  Network network;
  network.section = section;
  network.is_stray = true;
  network.range = network.keyword = CurrentLine().range;
  const NetworkId id = program_.networks.Add(std::move(network));
  ++program_.sections[section].networks.count;
  bodies_.push_back({.network = id, .file = file, .first = line_});
}

void Parser::TakeBodyLine(SectionId section, uint32_t file) {
  Line& line = CurrentLine();
  if (line.kind == LineKind::kBlank) return;
  if (line.kind == LineKind::kComment) {
    comments_.push_back(line.comment);
    return;
  }
  const std::string_view word = WordOf(line);
  if (program_.sections[section].networks.count == 0) {
    Begin(line);
    if (MnemonicByName(word) || PartByName(word)) {
      Fault(line.range, diag::Host50OutsideNetwork, TextOf(Peek()));
      line.faulty = true;
    }
    OpenStrayNetwork(section, file);
  }
  comments_.clear();  // those of instructions are taken with them
  if (PartByName(word) == PartKind::kLadder) {
    CloseLadder();
    open_ladder_ = line.range;
  } else if (PartByEnd(word) == PartKind::kLadder) {
    Begin(line);
    if (!open_ladder_) {
      Fault(Peek().range, diag::Host50UnexpectedEnd, word, "closes nothing");
      line.consumed = true;
    } else {
      ReadEnd();
    }
    open_ladder_.reset();
  } else if (line.kind == LineKind::kStatement) {
    CloseLadder();
  }
}

/// E311 when a drawing is open.
void Parser::CloseLadder() {
  if (open_ladder_) Report(*open_ladder_, diag::Host50MissingEnd, Name(PartKind::kLadder));
  open_ladder_.reset();
}

/// Networks and instructions outside of any section, up to the next part.
void Parser::ReadStray(uint32_t file) {
  Section section;
  section.range = section.keyword = CurrentLine().range;
  section.networks.first = program_.networks.size();
  const SectionId id = program_.sections.Add(std::move(section));
  bool reported = false;
  for (; line_ < files_[file].lines.size(); ++line_) {
    Line& line = CurrentLine();
    const std::string_view word = WordOf(line);
    const auto end = PartByEnd(word);
    if (Opener(word) || IsDirective(word) || (end && end != PartKind::kLadder)) break;
    if (!EqualIgnoringCase(word, kNetwork)) {
      TakeBodyLine(id, file);
      continue;
    }
    CloseBody();
    Begin(line);
    if (!std::exchange(reported, true)) Fault(line.range, diag::Host50OutsideSection);
    OpenStrayNetwork(id, file);
    bodies_.back().first = line_ + 1;
  }
  CloseBody();
}

}  // namespace plcxx::host50
