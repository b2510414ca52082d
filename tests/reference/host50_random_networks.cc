#include "tests/reference/host50_random_networks.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace plcxx::reference::host50_random {
namespace {

/// By number: TM0, TM1 ..., again from TM9 on.
constexpr const char* kTimerKinds[] = {"TONMS", "TONS", "TOFMS", "TPMS", "TOFS", "TPS", "TONM", "TOFM", "TPM"};

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace

std::vector<Piece> Networks::Symbols() const {
  std::vector<Piece> lines;
  for (const NamedAddress& named : names_) {
    lines.push_back({named.address + " '" + named.name + "' \"a comment\"", {}, ""});
  }
  return lines;
}

// --- operands ---

/// In one of its spellings.
std::string Networks::Address(const std::string& address) {
  for (const NamedAddress& named : names_) {
    if (address != named.address || random_.OneIn(2)) continue;
    const bool quoted = named.name.find('-') != std::string::npos || random_.OneIn(3);
    if (is_plain_) return address;
    return quoted ? "'" + named.name + "'" : named.name;
  }
  std::string small = address;
  for (char& c : small) c = static_cast<char>(std::tolower(c));
  std::string padded = address;
  const size_t digit = padded.find_first_of("0123456789");
  // At most five digits (2.4).
  const size_t digits = digit == std::string::npos ? 5 : std::min(padded.find('.', digit), padded.size()) - digit;
  if (digits < 5) padded.insert(digit, digits < 4 ? "00" : "0");
  if (address.starts_with("%TM")) padded.erase(2, 1);  // %T is %TM
  return Spelled({address, address, address, address, address, address, address, address, small, padded});
}

std::string Networks::Chain(Texts parts, Texts operators, const std::string& tighter) const {
  if (!is_plain_) {
    std::string text = parts[0];
    for (size_t i = 0; i < operators.size(); ++i) text += operators[i] + parts[i + 1];
    return text;
  }
  const auto join = [&](size_t i) {
    parts[i] = "(" + parts[i] + operators[i] + parts[i + 1] + ")";
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    operators.erase(operators.begin() + static_cast<std::ptrdiff_t>(i));
  };
  for (size_t i = 0; i < operators.size();) {
    if (operators[i].find(tighter) != std::string::npos) {
      join(i);
    } else {
      ++i;
    }
  }
  while (!operators.empty()) join(0);
  return parts[0];
}

void Networks::ChooseHabits(uint32_t channels) {
  if (random_.OneIn(3)) return;
  const auto any_of = [&](uint32_t size) {
    return random_.OneIn(4) ? size - 1 - random_.Below(2) : random_.OneIn(4) ? random_.Below(3) : random_.Below(size);
  };
  // The addresses of channel k are 2000 or 200 higher (5).
  const auto with_channel = [&](uint32_t number, uint32_t first, uint32_t step) {
    return std::to_string(number + (number >= first ? step * random_.Below(channels) : 0));
  };
  const auto bits = [&](const char* area) {
    const bool has_channels = area[1] != 'B';
    return area + (has_channels ? with_channel(any_of(2001), 500, 2000) : std::to_string(any_of(2001)));
  };
  const auto numbers = [&](const char* area) {
    const bool has_channels = area[1] == 'I' || area[1] == 'Q';
    return area + (has_channels ? with_channel(any_of(301), 100, 200) : std::to_string(any_of(301)));
  };
  timers_ = {1};
  for (uint32_t i = random_.Between(1, 8); i > 0; --i) timers_.push_back(any_of(101));
  counters_ = {"%C1"};
  for (uint32_t i = random_.Between(1, 3); i > 0; --i) counters_.push_back("%C" + std::to_string(any_of(101)));
  bits_ = {"%I0", "%B1"};
  coils_.clear();
  for (uint32_t i = random_.Between(2, 6); i > 0; --i) bits_.push_back(bits("%I"));
  for (uint32_t i = random_.Between(2, 8); i > 0; --i) {
    coils_.push_back(bits(random_.OneIn(2) ? "%Q" : "%B"));
    bits_.push_back(coils_.back());
  }
  words_.clear(), results_.clear(), floats_.clear(), float_results_.clear();
  for (uint32_t i = random_.Between(2, 6); i > 0; --i) {
    results_.push_back(numbers(random_.OneIn(4) ? "%QW" : "%W"));
    float_results_.push_back(numbers(random_.OneIn(4) ? "%QF" : "%F"));
    words_.push_back(results_.back());
    floats_.push_back(float_results_.back());
    if (random_.OneIn(3)) words_.push_back(numbers("%IW"));
    if (random_.OneIn(3)) floats_.push_back(numbers("%IF"));
  }
  for (const uint32_t timer : timers_) {
    const std::string name = "%TM" + std::to_string(timer);
    bits_.push_back(name + (random_.OneIn(2) ? ".Q" : ""));
    words_.push_back(name + (random_.OneIn(3) ? ".P" : ".V"));
  }
  for (const std::string& counter : counters_) {
    bits_.push_back(counter + (random_.OneIn(2) ? ".Q" : ""));
    words_.push_back(counter + (random_.OneIn(3) ? ".P" : ".V"));
    if (random_.OneIn(2)) results_.push_back(counter + ".V");
  }
  AwkwardNames awkward;
  for (const std::string& address : bits_) {
    const bool is_named = std::ranges::find(names_, address, &NamedAddress::address) != names_.end();
    if (is_named || address[1] == 'T' || address[1] == 'C' || !random_.OneIn(3)) continue;
    if (const std::string name = awkward.Next(random_); !name.empty()) names_.push_back({address, name});
  }
  for (const std::string& address : results_) {
    const bool is_named = std::ranges::find(names_, address, &NamedAddress::address) != names_.end();
    if (is_named || address[1] == 'C' || !random_.OneIn(3)) continue;
    if (const std::string name = awkward.Next(random_); !name.empty()) names_.push_back({address, name});
  }
  deepest_ = random_.Between(0, 5);
  most_contacts_ = random_.Between(1, 8);
  most_outputs_ = random_.Between(1, 6);
  one_drawing_in_ = random_.Between(1, 12);
  one_jump_in_ = random_.Between(1, 12);
  one_branch_in_ = random_.Between(2, 12);
  one_coil_in_ = random_.Between(1, 4);
}

std::string Networks::Bit() {
  // The control's own, by their names (option PREDEFINED).
  if (predefined_ && random_.OneIn(8)) {
    static const std::vector<std::pair<std::string, std::string>> kSignals = {
        {"%I500", "NC_ESTOP_STATE"}, {"%I503", "NC_RESET"},   {"%I540", "NC_M_STROBE"},
        {"%I600", "NC_MODE_AUTO"},   {"%I522", "NC_RUNNING"}, {"%I401", "USER_PARAM_1"}};
    const auto& [address, name] = random_.Pick(kSignals);
    return is_plain_ ? address : name;
  }
  return Address(random_.Pick(bits_));
}
std::string Networks::Coil() { return Address(random_.Pick(coils_)); }
std::string Networks::WholeConstant() {
  if (random_.OneIn(6)) {
    static const std::vector<Texts> kForms = {{"2147483647", "$7FFFFFFF", "02147483647"},
                                              {"-2147483648", "$80000000"},
                                              {"-1", "$FFFFFFFF", "$ffffffff"},
                                              {"32767", "$7FFF", "+32767"},
                                              {"5", "+5", "$5", "$00000005"},
                                              {"65536", "$10000"},
                                              {"-32768", "$FFFF8000"}};
    return Spelled(random_.Pick(kForms));
  }
  return Padded(random_.Below(10));
}
std::string Networks::Whole() { return random_.OneIn(3) ? WholeConstant() : Address(random_.Pick(words_)); }
std::string Networks::WholeResult() { return Address(random_.Pick(results_)); }
std::string Networks::RealConstant() {
  static const std::vector<Texts> kForms = {{"1.5", "+1.50", "15e-1", "015E-1"},
                                            {"1.", "1.0", "1e0"},
                                            {".5", "0.5", "5e-1"},
                                            {"-2.25", "-02.250"},
                                            {"3", "$3"},
                                            {"1e3", "1E+3", "1000.0"},
                                            {"1.0e-3", ".001"},
                                            {"-7", "-07"},
                                            {"0.0"},
                                            {"0.1", ".1"},
                                            {"16777217"},
                                            {"1e38"},
                                            {"2147483648.0"},
                                            {"-1e-40"},
                                            {"-1", "$FFFFFFFF"}};
  return Spelled(random_.Pick(kForms));
}
std::string Networks::Real() { return random_.OneIn(3) ? RealConstant() : Address(random_.Pick(floats_)); }
std::string Networks::RealResult() { return Address(random_.Pick(float_results_)); }

/// The address behind a name of an expression.
std::string Networks::Plain(const std::string& operand) const {
  if (!is_plain_) return operand;
  std::string name = operand;
  std::erase(name, '\'');
  const size_t dot = name.starts_with('%') ? std::string::npos : name.find('.');
  for (const NamedAddress& named : names_) {
    if (name.substr(0, dot) == named.name) return named.address + (dot == std::string::npos ? "" : name.substr(dot));
  }
  return operand;
}

std::string Networks::Primary(uint32_t depth, bool whole_only) {
  static const Texts kWords = {"%W0",     "'Count_1'", "Count_1", "%W300", "%IW0",   "%QW5",  "%TM0.V",
                               "T_RUN.V", "'T_RUN'.P", "%C1.V",   "%I0",   "START",  "%B500", "%TM1.Q",
                               "%C1.P",   "%C1.Q",     "%QW0",    "%Q0",   "%IW110", "%TM2.P"};
  static const Texts kFloats = {"%F0", "speed", "%F101", "%IF0", "%QF10", "1.5", ".5", "1e3", "0.1"};
  const std::string sign = random_.OneIn(6) ? random_.Pick(Texts{"-", "+"}) : "";
  if (depth > 0 && random_.OneIn(4)) return sign + "(" + Expression(depth - 1, whole_only) + ")";
  if (!whole_only && random_.OneIn(2)) {
    return sign + Plain(random_.OneIn(2) ? random_.Pick(kFloats) : random_.Pick(floats_));
  }
  if (random_.OneIn(3)) {
    static const std::vector<Texts> kForms = {{"0", "$0"},    {"1", "001"},  {"2"},         {"3"},          {"7"},
                                              {"100", "$64"}, {"15", "$0F"}, {"$FFFFFFFF"}, {"2147483647"}, {"65536"}};
    return sign + Spelled(random_.Pick(kForms));
  }
  return sign + Plain(random_.OneIn(2) ? random_.Pick(kWords) : random_.Pick(random_.OneIn(3) ? bits_ : words_));
}

std::string Networks::Expression(uint32_t depth, bool whole_only) {
  const auto gap = [&] { return Spelled({" ", "", "\t", "  ", " \\\n "}); };
  const auto chain = [&](uint32_t least, uint32_t most, const Texts& choice, auto&& part) {
    Texts parts = {part()}, operators;
    for (uint32_t i = random_.Between(least, most); i > 0; --i) {
      std::string text = gap();
      text += random_.Pick(choice);
      operators.push_back(text + gap());
      parts.push_back(part());
    }
    return Chain(std::move(parts), std::move(operators), "&");
  };
  const auto product = [&](bool whole) { return chain(0, 2, {"*", "/"}, [&] { return Primary(depth, whole); }); };
  const auto sum = [&](bool whole) { return chain(0, 2, {"+", "-"}, [&] { return product(whole); }); };
  if (!random_.OneIn(4)) return sum(whole_only);
  return chain(1, 3, {"&", "|"}, [&] { return sum(true); });
}

std::string Networks::Relation() {
  const auto side = [&] {
    const bool whole = random_.OneIn(2);
    return random_.OneIn(2) ? Primary(0, whole) : Expression(2, whole);
  };
  const std::string left = side();
  const std::string relation = random_.Pick(Texts{">", "<", ">=", "<=", "=", "<>"});
  return left + " " + relation + " " + side();
}

// --- instruction lists ---

void Networks::Line(const std::string& text) {
  ++made_;
  std::string line = Spelled({"  ", "  ", "", "\t", " "}) + Respelled(text);
  line += Spelled({"", "", "", "", "", "", "", "", " ", " ; it is 5 o'clock \\", ";\xE4\xB8\xAD\xE6\x96\x87"});
  if (random_.OneIn(60)) {
    const std::string number = std::to_string(made_);
    lines_.push_back(random_.Pick(Texts{"  REMARK \"remark " + number + "\"", "  REMARK say \"" + number + "\"; LD %I0",
                                        "REMARK", "  REMARK \"a \"\"quoted\"\" word\""}));
  }
  lines_.push_back(line);
}

/// The instruction's word small, its blanks as tabs or more blanks, or a second line of it.
std::string Networks::Respelled(const std::string& text) {
  const size_t blank = text.find(' ');
  const uint32_t form = random_.Below(24);
  // A second line of a line that has one already would be wrong in a text; names keep their case.
  if (is_plain_ || form > 3 || blank == std::string::npos || text.find_first_of("\"\\") != std::string::npos)
    return text;
  std::string word = text.substr(0, blank), rest = text.substr(blank + 1);
  if (form < 2) {
    for (char& c : word) c = static_cast<char>(std::tolower(c));
  }
  const char* const between[] = {" ", "\t ", " \\\n   ", "   "};
  return word + between[form] + rest;
}

/// LD, AND or OR in one of its forms.
std::string Networks::Edge(const std::string& plain) {
  switch (random_.Below(8)) {
    case 0:
      return plain + "P";
    case 1:
      return plain + "F";
    case 2:
    case 3:
      return plain + "I";
    default:
      return plain;
  }
}

void Networks::Load() {
  if (random_.OneIn(8)) {
    Line(random_.Pick(Texts{"LD 1", "LD 0", "LDI 0", "LDI 1", "LD 1"}));
  } else {
    Line(Edge("LD") + " " + Bit());
  }
}

/// Behind something live.
void Networks::Contacts(uint32_t depth) {
  for (uint32_t i = random_.Below(most_contacts_ + 1); i > 0; --i) {
    const uint32_t choice = random_.Below(depth > 0 ? 8 : 5);
    if (choice < 3) {
      std::string word = Edge("AND");
      if (word != "AND") word = Spelled({word, "AN" + word.substr(3)});
      Line(word + " " + Bit());
    } else if (choice < 5) {
      Line(Edge("OR") + " " + Bit());
    } else if (choice < 7) {
      Logic(depth - 1);
      Line(random_.OneIn(3) ? "ORB" : Spelled({"ANB", "ANDB"}));
    } else {
      Rest(depth - 1);
    }
  }
}

/// A block with Q behind something live.
void Networks::Rest(uint32_t depth) {
  switch (random_.Below(6)) {
    case 0:
      Line(Timer());
      break;
    case 1:
      Counter();
      break;
    case 2:
      Rotation();
      break;
    default:
      Line(Compare());
      break;
  }
  if (depth > 0) Contacts(depth - 1);
}

/// Begins with LD; leaves one value on top of what was there.
void Networks::Logic(uint32_t depth) {
  Load();
  Contacts(depth);
  if (depth == 0 || !random_.OneIn(5)) return;
  // Several blocks, joined at the end.
  const uint32_t blocks = random_.Between(1, 3);
  for (uint32_t i = 0; i < blocks; ++i) Logic(depth - 1);
  for (uint32_t i = 0; i < blocks; ++i) Line(random_.Pick(Texts{"ORB", "ANB"}));
}

/// LD of its pins, then the block (3.4); the main input is live.
void Networks::Counter() {
  std::string pins;
  for (const char* name : {"P", "M", "N"}) {
    if (random_.OneIn(3)) {
      Logic(0);
    } else {
      pins += ", " + Pin(name);
    }
  }
  Line("CNUD " + Address(random_.Pick(counters_)) + ", " + Whole() + pins);
}

void Networks::Rotation() {
  std::string pin;
  if (random_.OneIn(2)) {
    Logic(0);
  } else {
    pin = ", " + Pin("M");
  }
  const std::string positions = random_.OneIn(3) ? Whole() : std::to_string(random_.Between(3, 12));
  Line("ROT " + positions + ", " + Whole() + ", " + Whole() + ", " + WholeResult() + pin);
}

std::string Networks::Pin(const std::string& name) {
  if (random_.OneIn(2)) return name + "=" + (random_.OneIn(2) ? "0" : "1");
  return name + "=" + (random_.OneIn(3) ? "!" : "") + Bit();
}

std::string Networks::Timer() {
  const uint32_t number = random_.Pick(timers_);
  const std::string preset = random_.OneIn(3) ? Whole() : std::to_string(random_.Below(4));
  const std::string address = Address("%TM" + std::to_string(number));
  const std::string kind = kTimerKinds[number % std::size(kTimerKinds)];
  const size_t letters = kind.starts_with("TP") ? 2 : 3;  // TON, TOF, TP, then the unit
  const std::string unit = kind.substr(letters);
  const std::string other = unit == "S" ? "SEC" : unit == "M" ? "MIN" : unit;
  const std::string name = kind.substr(0, letters) + " " + address + ", ";
  const std::string joined = kind + " " + address + ", " + preset;
  return Spelled({joined, joined, joined, name + unit + ", " + preset, name + other + "," + preset});
}

std::string Networks::Compare() {
  if (random_.OneIn(2)) {
    const std::string relation = Relation();
    return "COMP " + InQuotes(relation);
  }
  std::string word = random_.Pick(Texts{"EQ", "NE", "GT", "GE", "LT", "LE"});
  if (word == "GT") word = Spelled({"GT", "GL"});
  const std::string left = Number();
  const std::string comma = Comma();
  return word + " " + left + comma + Number();
}

std::string Networks::Axis() {
  const std::string axis = random_.OneIn(2) ? Whole() : std::to_string(random_.Between(1, 9));
  // A constant has to name one.
  const bool outside =
      axis.find_first_of("%'") == std::string::npos && std::isalpha(static_cast<unsigned char>(axis[0])) == 0;
  const std::string number = outside ? std::to_string(random_.Between(1, 9)) : axis;
  const std::string speed = Real();
  const std::string position = random_.OneIn(2) ? Real() : Whole();
  switch (random_.Below(5)) {
    case 0:
      return "HOME " + number + ", " + Whole() + ", " + speed;
    case 1:
      return "POSA " + number + ", " + position + ", " + speed;
    case 2:
      return "POSM " + number + ", " + position + ", " + speed;
    case 3:
      return "VELP " + number + ", " + speed;
    default:
      return "VELN " + number + ", " + speed;
  }
}

std::string Networks::BlockWithoutQ() {
  switch (random_.Below(11)) {
    case 0:
    case 1:
      return random_.Pick(Texts{"ADDW", "SUBW", "MULW", "DIVW", "WAND", "WOR", "WXOR"}) + " " + Whole() + ", " +
             Whole() + ", " + WholeResult();
    case 2:
      return random_.Pick(Texts{"ADDF", "SUBF", "MULF", "DIVF"}) + " " + Real() + ", " + Real() + ", " + RealResult();
    case 3:
      return "NEG " + (random_.OneIn(2) ? WholeResult() : RealResult());
    case 4:
      return random_.OneIn(2) ? "FTOW " + Real() + ", " + WholeResult() : "WTOF " + Whole() + ", " + RealResult();
    case 5: {
      const uint32_t count = random_.Between(1, 32);
      static const Texts kFields = {"%B0", "%B490", "%I0", "%I500", "%Q0", "%Q400", "%B1969", "%Q1969"};
      return "BTOW " + Address(random_.Pick(kFields)) + ", " + WholeResult() + ", " + std::to_string(count);
    }
    case 6: {
      const uint32_t count = random_.Between(1, 32);
      const std::string word = Spelled({"WTOB", "WIOB"});
      return word + " " + Whole() + ", " + Address(random_.Pick(Texts{"%B0", "%B490", "%Q0", "%Q400", "%B1969"})) +
             ", " + std::to_string(count);
    }
    case 7: {
      std::string text = random_.OneIn(2) ? WholeResult() : RealResult();
      // In an expression a bare name has letters, digits and "_" only (2.5).
      text += Spelled({" = ", " := ", "=", " :="});
      text += Expression(2, random_.OneIn(2));
      return "OPRT " + InQuotes(text);
    }
    case 8:
      return Axis();
    case 9:
      if (section_ == Section::kOther && callees_.first <= callees_.last && callees_.most > 0) {
        --callees_.most;
        return "CALL SR" + Padded(random_.Between(callees_.first, callees_.last) - 1);
      }
      [[fallthrough]];
    default:
      return "MOV " + Number() + ", " + (random_.OneIn(2) ? WholeResult() : RealResult());
  }
}

void Networks::Output() {
  if (random_.OneIn(one_coil_in_)) {
    Line(random_.Pick(Texts{"OUT", "OUT", "OUTI", "SET", "RST"}) + " " + Coil());
    return;
  }
  Line(BlockWithoutQ());
}

void Networks::Outputs() {
  Output();
  for (uint32_t i = random_.Below(most_outputs_ + 1); i > 0; --i) {
    if (random_.OneIn(3)) {
      Line("AND " + Bit());
    } else if (random_.OneIn(4)) {
      Line(Compare());
    }
    Output();
  }
}

Piece Networks::Rung() {
  lines_.clear();
  if (random_.OneIn(5)) {  // an input that stays long enough for a timer
    Line("LD " + Address(random_.Pick(Texts{"%I0", "%I1", "%I2", "%I3"})));
    Line(Timer());
    Line("OUT " + Coil());
    return {Joined(lines_), {}, ""};
  }
  Logic(deepest_);
  if (random_.OneIn(4)) Rest(2);
  if (random_.OneIn(one_branch_in_)) {
    const uint32_t branches = random_.Between(1, 3);
    Line("MPS");
    for (uint32_t i = 0; i <= branches; ++i) {
      if (i > 0) Line(i == branches ? "MPP" : "MRD");
      const uint32_t choice = random_.Below(3);
      if (choice == 0) {
        Line("AND " + Bit());
      } else if (choice == 1) {
        Logic(1);
        Line("ANB");
      }
      if (i + 1 < branches && random_.OneIn(6)) {
        Line("MPS");
        Outputs();
        Line("MPP");
        Line("ANI " + Bit());
      }
      Outputs();
    }
  } else if (random_.OneIn(12)) {
    Line(Timer());
    lines_.push_back("  RUNG");
  } else {
    Outputs();
  }
  return {Joined(lines_), {}, ""};
}

Piece Networks::Network(uint32_t position, uint32_t count, uint32_t wanted) {
  position_ = position;
  count_ = count;
  std::string head = Spelled({"NETWORK L", "NETWORK L", " network l", "NETWORK\tL"}) + Padded(position + 10);
  // Its label is implied: nothing jumps in the fast part.
  if (section_ == Section::kFast && random_.OneIn(3)) head = "NETWORK";
  head += Spelled({"", "", " \"network\"", " \"say \"\"go\"\"; \xE4\xB8\xAD\xE6\x96\x87\"", " ; comment"});
  Piece network{head, {}, ""};
  if (random_.OneIn(one_drawing_in_)) {
    network.body.push_back(Drawing());
    return network;
  }
  if (random_.OneIn(12)) return network;
  do {
    network.body.push_back(Rung());
  } while (made_ < wanted);
  // A jump: forward as a rule; backward ones may end at the guard.
  if (section_ == Section::kOther && random_.OneIn(one_jump_in_)) {
    // Each section has a guard of its own (4.8): of sections that call each other the jumps multiply, without an end
    // that anybody waits for. So they are where nothing is called, or in the one that the slow part calls.
    const bool is_leaf = callees_.first > callees_.last && callees_.last <= 1;
    const bool backward = is_leaf && random_.OneIn(6);
    const uint32_t target = backward               ? random_.Between(0, position)
                            : position + 1 < count ? random_.Between(position + 1, count - 1)
                                                   : count;
    if (target < count) {
      lines_.clear();
      Load();
      if (backward) {  // one in three without a limit: the guard of 4.8 ends it
        if (!random_.OneIn(3)) Line("LT %W2, " + std::to_string(random_.Below(40)));
        Line("ADDW %W2, 1, %W2");
      }
      Line("LBL J" + Padded(target + 10));
      network.body.insert(network.body.begin() + random_.Below(static_cast<uint32_t>(network.body.size()) + 1),
                          {Joined(lines_), {}, ""});
    }
  }
  return network;
}

}  // namespace plcxx::reference::host50_random
