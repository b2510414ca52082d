#include "tests/reference/host50_random_networks.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace plcxx::reference::host50_random {
namespace {

struct NamedAddress {
  const char *address, *name;
};
constexpr NamedAddress kNames[] = {{"%I0", "START"}, {"%B1", "axis4-"}, {"%Q0", "PUMP"}, {"%W1", "Count_1"},
                                   {"%F0", "speed"}, {"%TM1", "T_RUN"}, {"%C1", "TURNS"}};

/// By number: TM0, TM1 ...
constexpr const char* kTimerKinds[] = {"TONMS", "TONS", "TOFMS", "TPMS", "TOFS", "TPS", "TONM", "TOFM", "TPM"};

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace

std::vector<Piece> Networks::Symbols() const {
  std::vector<Piece> lines;
  for (const NamedAddress& named : kNames) {
    lines.push_back({std::string(named.address) + " '" + named.name + "' \"a comment\"", {}, ""});
  }
  return lines;
}

// --- operands ---

/// In one of its spellings.
std::string Networks::Address(const std::string& address) {
  for (const NamedAddress& named : kNames) {
    if (address != named.address || random_.OneIn(2)) continue;
    const bool quoted = std::string(named.name).find('-') != std::string::npos || random_.OneIn(3);
    if (is_plain_) return address;
    return quoted ? "'" + std::string(named.name) + "'" : named.name;
  }
  std::string small = address;
  for (char& c : small) c = static_cast<char>(std::tolower(c));
  std::string padded = address;
  const size_t digit = padded.find_first_of("0123456789");
  if (digit != std::string::npos) padded.insert(digit, address.size() - digit < 4 ? "00" : "0");
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

std::string Networks::Bit() {
  static const Texts kBits = {"%I0",    "%I1",   "%I2",    "%I3",    "%I4", "%I199",  "%I500", "%I2000", "%Q0",
                              "%Q1",    "%Q400", "%Q1000", "%Q2000", "%B0", "%B1",    "%B499", "%B500",  "%B501",
                              "%B2000", "%TM0",  "%TM1.Q", "%TM2",   "%T3", "%TM4.Q", "%C0",   "%C1.Q",  "%C100"};
  return Address(random_.Pick(kBits));
}
std::string Networks::Coil() {
  static const Texts kCoils = {"%Q0", "%Q1", "%Q2", "%Q400", "%Q401", "%Q499", "%Q1000", "%Q2000",
                               "%B0", "%B1", "%B2", "%B499", "%B500", "%B501", "%B2000"};
  return Address(random_.Pick(kCoils));
}
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
std::string Networks::Whole() {
  static const Texts kWords = {"%W0",  "%W1",  "%W2",    "%W100",  "%W101",  "%W300",  "%IW0",  "%IW110", "%IW300",
                               "%QW0", "%QW5", "%TM0.V", "%TM1.V", "%TM2.P", "%TM3.V", "%C0.V", "%C1.V",  "%C100.P"};
  return random_.OneIn(3) ? WholeConstant() : Address(random_.Pick(kWords));
}
std::string Networks::WholeResult() {
  static const Texts kWords = {"%W0", "%W1", "%W2", "%W100", "%W101", "%W300", "%QW0", "%QW5", "%IW0", "%C1.V"};
  return Address(random_.Pick(kWords));
}
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
std::string Networks::Real() {
  static const Texts kFloats = {"%F0", "%F1", "%F100", "%F101", "%F300", "%IF0", "%IF300", "%QF0", "%QF10"};
  return random_.OneIn(3) ? RealConstant() : Address(random_.Pick(kFloats));
}
std::string Networks::RealResult() {
  static const Texts kFloats = {"%F0", "%F1", "%F100", "%F101", "%F300", "%QF0", "%QF10", "%IF0"};
  return Address(random_.Pick(kFloats));
}

/// The address behind a name of an expression.
std::string Networks::Plain(const std::string& operand) const {
  if (!is_plain_) return operand;
  std::string name = operand;
  std::erase(name, '\'');
  const size_t dot = name.starts_with('%') ? std::string::npos : name.find('.');
  for (const NamedAddress& named : kNames) {
    if (name.substr(0, dot) == named.name) return named.address + (dot == std::string::npos ? "" : name.substr(dot));
  }
  return operand;
}

std::string Networks::Primary(uint32_t depth, bool whole_only) {
  static const Texts kWords = {"%W0",     "'Count_1'", "Count_1", "%W300", "%IW0",  "%QW5",  "%TM0.V",
                               "T_RUN.V", "'T_RUN'.P", "%C1.V",   "%I0",   "START", "%B500", "%TM1.Q"};
  static const Texts kFloats = {"%F0", "speed", "%F101", "%IF0", "%QF10", "1.5", ".5", "1e3", "0.1"};
  const std::string sign = random_.OneIn(6) ? random_.Pick(Texts{"-", "+"}) : "";
  if (depth > 0 && random_.OneIn(4)) return sign + "(" + Expression(depth - 1, whole_only) + ")";
  if (!whole_only && random_.OneIn(2)) return sign + Plain(random_.Pick(kFloats));
  if (random_.OneIn(3)) {
    static const std::vector<Texts> kForms = {{"0", "$0"},    {"1", "001"},  {"2"},         {"3"},          {"7"},
                                              {"100", "$64"}, {"15", "$0F"}, {"$FFFFFFFF"}, {"2147483647"}, {"65536"}};
    return sign + Spelled(random_.Pick(kForms));
  }
  return sign + Plain(random_.Pick(kWords));
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
  const std::string left = Expression(2, random_.OneIn(2));
  return left + " " + random_.Pick(Texts{">", "<", ">=", "<=", "=", "<>"}) + " " + Expression(2, random_.OneIn(2));
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
  for (uint32_t i = random_.Below(3); i > 0; --i) {
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
  Line("CNUD " + Address(random_.Pick(Texts{"%C0", "%C1", "%C100"})) + ", " + Whole() + pins);
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
  const uint32_t number = random_.Below(std::size(kTimerKinds));
  const std::string preset = random_.OneIn(3) ? Whole() : std::to_string(random_.Below(4));
  const std::string address = Address("%TM" + std::to_string(number));
  const std::string kind = kTimerKinds[number];
  const size_t letters = kind.starts_with("TP") ? 2 : 3;  // TON, TOF, TP, then the unit
  const std::string unit = kind.substr(letters);
  const std::string other = unit == "S" ? "SEC" : unit == "M" ? "MIN" : unit;
  const std::string name = kind.substr(0, letters) + " " + address + ", ";
  const std::string joined = kind + " " + address + ", " + preset;
  return Spelled({joined, joined, joined, name + unit + ", " + preset, name + other + "," + preset});
}

std::string Networks::Compare() {
  if (random_.OneIn(3)) {
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
      if (section_ == Section::kOther && callees_.first <= callees_.last)
        return "CALL SR" + Padded(random_.Between(callees_.first, callees_.last) - 1);
      [[fallthrough]];
    default:
      return "MOV " + Number() + ", " + (random_.OneIn(2) ? WholeResult() : RealResult());
  }
}

void Networks::Output() {
  if (random_.OneIn(2)) {
    Line(random_.Pick(Texts{"OUT", "OUT", "OUTI", "SET", "RST"}) + " " + Coil());
    return;
  }
  Line(BlockWithoutQ());
}

void Networks::Outputs() {
  Output();
  for (uint32_t i = random_.Below(3); i > 0; --i) {
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
  Logic(3);
  if (random_.OneIn(4)) Rest(2);
  if (random_.OneIn(6)) {
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
  if (random_.OneIn(5)) {
    network.body.push_back(Drawing());
    return network;
  }
  if (random_.OneIn(12)) return network;
  do {
    network.body.push_back(Rung());
  } while (made_ < wanted);
  // A jump: forward as a rule; backward ones may end at the guard.
  if (section_ == Section::kOther && random_.OneIn(5)) {
    const bool backward = random_.OneIn(8);
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

// --- drawings (3.6): parallel contacts, a line of elements, several outputs ---

std::string Networks::DrawnContact() {
  ++made_;
  return random_.Pick(Texts{"[ ", "[ ", "[/", "[P ", "[N "}) + Bit() + " ]";
}

/// A row of a drawing has no tabs and no second line.
std::string Networks::OneLine(std::string text) {
  for (size_t at = text.find("\\\n"); at != std::string::npos; at = text.find("\\\n")) text.erase(at, 2);
  std::ranges::replace(text, '\t', ' ');
  return text;
}

std::string Networks::DrawnOutput() {
  ++made_;
  if (random_.OneIn(3)) return "{" + OneLine(BlockWithoutQ()) + "}";
  if (random_.OneIn(8)) return "{" + OneLine(Timer()) + "}";
  return random_.Pick(Texts{"( ", "( ", "(/", "(S ", "(R "}) + Coil() + " )";
}

Piece Networks::Drawing() {
  const uint32_t contacts = random_.Between(1, 3), outputs = random_.Between(1, 3);
  std::vector<std::string> rows(std::max(contacts, outputs), "  |");
  const auto widest = [&] {
    size_t width = 0;
    for (const std::string& row : rows) width = std::max(width, row.size());
    return width;
  };
  for (uint32_t i = 0; i < contacts; ++i) {
    rows[i] += "--" + DrawnContact();
    if (random_.OneIn(3)) rows[i] += "--" + DrawnContact();
  }
  const size_t first = widest() + 2;
  for (uint32_t i = 0; i < contacts; ++i) rows[i] += std::string(first - rows[i].size(), '-') + "+";
  for (uint32_t i = random_.Below(3); i > 0; --i) {
    switch (random_.Below(5)) {
      case 0:
        rows[0] += "--{" + OneLine(Timer()) + "}";
        break;
      case 1:
        rows[0] += "--{" + OneLine(Compare()) + "}";
        break;
      case 2:
        rows[0] += "--{CNUD %C0, " + Whole() + ", " + Pin("P") + ", " + Pin("M") + ", " + Pin("N") + "}";
        break;
      default:
        rows[0] += "--" + DrawnContact();
        break;
    }
  }
  const size_t second = std::max(rows[0].size(), widest()) + 1;
  rows[0] += std::string(second - rows[0].size(), '-') + "+";
  for (uint32_t i = 1; i < outputs; ++i) rows[i] += std::string(second - rows[i].size(), ' ') + "+";
  for (uint32_t i = 0; i < outputs; ++i) {
    if (random_.OneIn(3)) rows[i] += "--" + DrawnContact();
    rows[i] += "----" + DrawnOutput();
  }
  std::string remark;
  if (random_.OneIn(8)) remark = "REMARK \"a drawing\"\n";
  return {remark + "LADDER\n" + Joined(rows) + "\nEND_LADDER", {}, ""};
}

}  // namespace plcxx::reference::host50_random
