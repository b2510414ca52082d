#include "transpiler/dialects/host50/parser/section_reader.h"

namespace plcxx::host50 {
namespace {

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

}  // namespace

void SectionReader::CloseBody(uint32_t end) {
  CloseLadder();
  if (!parts_.bodies.empty() && parts_.bodies.back().last == 0) parts_.bodies.back().last = end;
}

void SectionReader::AddEndComments(SectionId section) {
  if (comments_.empty()) return;
  Span& at_end = program_.sections[section].end_comments;
  std::vector<source::Range> all;
  for (uint32_t i = 0; i < at_end.count; ++i) all.push_back(program_.comments[at_end.first + i].range);
  all.insert(all.end(), comments_.begin(), comments_.end());
  comments_.clear();
  at_end = AddComments(all, {});
}

SectionId SectionReader::OpenSection(PartKind part, const Line& line) {
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
      if (name.kind == TokenKind::kInteger) section.number = NumberBehind("", TextOf(name)).value_or(kNoNumber);
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

SectionId SectionReader::OpenStraySection(const Line& line) {
  Section section;
  section.range = section.keyword = line.range;
  section.networks.first = program_.networks.size();
  return program_.sections.Add(std::move(section));
}

void SectionReader::CheckSection(SectionId id) {
  Section& section = program_.sections[id];
  if (section.kind != SectionKind::kSubroutine) {
    section.duplicate = FindSection(program_, section.kind) != id;
    if (section.duplicate) Fault(section.keyword, diag::Host50DuplicateSection, TextOf(section.keyword));
  } else if (section.number != kNoNumber) {
    section.duplicate = !parts_.subroutines.emplace(section.number, id).second;
    if (section.duplicate) Fault(section.range, diag::Host50DuplicateSubroutine, SubroutineName(section.number));
  }
  if (++program_count_ > Available(Resource::kPrograms) && !std::exchange(programs_reported_, true)) {
    Fault(section.range, diag::Host50TooManyPrograms);
  }
}

void SectionReader::OpenNetwork(SectionId section, const Line& line, uint32_t number) {
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
  parts_.bodies.push_back({.network = id, .file = now_.file, .first = number + 1});
}

void SectionReader::ReadNetworkHead(Network& network) {
  network.keyword = Take().range;
  if (At(TokenKind::kWord) || At(TokenKind::kInteger)) {
    const Token label = Peek();
    const auto number = label.kind == TokenKind::kWord ? NumberBehind("L", TextOf(label)) : std::nullopt;
    if (!number) {
      Fault(label.range, diag::Host50LabelExpected, Found());
    } else if (*number > kGreatestLabel) {
      Fault(label.range, diag::Host50LabelRange, TextOf(label));
    } else {
      network.has_label = true;
      network.number = *number;
    }
    Take();
    if (At(TokenKind::kWord)) Fault(Peek().range, diag::Host50LabelExpected, Found());
  }
  if (At(TokenKind::kString)) network.comment = StringOf(Take());
  ExpectEnd();
}

void SectionReader::CheckNetwork(SectionId section, NetworkId id) {
  const Network& network = program_.networks[id];
  if (!now_.failed || network.has_label) {  // a label that could not be read has no number
    if (!parts_.labels.emplace(std::pair(section, network.number), id).second) {
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

void SectionReader::OpenStrayNetwork(SectionId section, const Line& line, uint32_t first) {
  Network network;
  network.section = section;
  network.is_stray = true;
  network.range = network.keyword = line.range;
  const NetworkId id = program_.networks.Add(std::move(network));
  ++program_.sections[section].networks.count;
  parts_.bodies.push_back({.network = id, .file = now_.file, .first = first});
}

void SectionReader::TakeBodyLine(SectionId section, Line& line, uint32_t number) {
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
    OpenStrayNetwork(section, line, number);
  }
  const bool ends_drawing = PartByEnd(word) == PartKind::kLadder;
  if (!ends_drawing) comments_.clear();  // those of instructions are taken with them
  if (ends_drawing && line.comment.end > line.comment.begin) comments_.push_back(line.comment);
  if (PartByName(word) == PartKind::kLadder) {
    CloseLadder();
    open_ladder_ = line.range;
  } else if (ends_drawing) {
    Begin(line);
    if (!open_ladder_) {
      Fault(Peek().range, diag::Host50UnexpectedEnd, word, "closes nothing");
      line.consumed = true;
    } else {
      Take();
      ExpectEnd();
    }
    open_ladder_.reset();
  } else if (line.kind == LineKind::kStatement) {
    CloseLadder();
  }
}

void SectionReader::CloseLadder() {
  if (open_ladder_) Report(*open_ladder_, diag::Host50MissingEnd, Name(PartKind::kLadder));
  open_ladder_.reset();
}

}  // namespace plcxx::host50
