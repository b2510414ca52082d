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
    return quoted ? "'" + std::string(named.name) + "'" : named.name;
  }
  if (!random_.OneIn(10)) return address;
  std::string small = address;
  for (char& c : small) c = static_cast<char>(std::tolower(c));
  return small;
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
  if (random_.OneIn(6))
    return random_.Pick(Texts{"2147483647", "-2147483648", "$FFFFFFFF", "$7FFF", "-1", "+5", "65536"});
  return std::to_string(random_.Below(10));
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
  return random_.Pick(Texts{"1.5", "1.", ".5", "-2.25", "3", "1e3", "1.0e-3", "-7", "0.0", "0.1", "16777217", "1e38",
                            "2147483648.0", "-1e-40"});
}
std::string Networks::Real() {
  static const Texts kFloats = {"%F0", "%F1", "%F100", "%F101", "%F300", "%IF0", "%IF300", "%QF0", "%QF10"};
  return random_.OneIn(3) ? RealConstant() : Address(random_.Pick(kFloats));
}
std::string Networks::RealResult() {
  static const Texts kFloats = {"%F0", "%F1", "%F100", "%F101", "%F300", "%QF0", "%QF10", "%IF0"};
  return Address(random_.Pick(kFloats));
}

std::string Networks::Primary(uint32_t depth, bool whole_only) {
  static const Texts kWords = {"%W0",     "'Count_1'", "Count_1", "%W300", "%IW0",  "%QW5",  "%TM0.V",
                               "T_RUN.V", "'T_RUN'.P", "%C1.V",   "%I0",   "START", "%B500", "%TM1.Q"};
  static const Texts kFloats = {"%F0", "speed", "%F101", "%IF0", "%QF10", "1.5", ".5", "1e3", "0.1"};
  const std::string sign = random_.OneIn(6) ? random_.Pick(Texts{"-", "+"}) : "";
  if (depth > 0 && random_.OneIn(4)) return sign + "(" + Expression(depth - 1, whole_only) + ")";
  if (!whole_only && random_.OneIn(2)) return sign + random_.Pick(kFloats);
  if (random_.OneIn(3))
    return sign + random_.Pick(Texts{"0", "1", "2", "3", "7", "100", "$0F", "$FFFFFFFF", "2147483647", "65536"});
  return sign + random_.Pick(kWords);
}

std::string Networks::Expression(uint32_t depth, bool whole_only) {
  const auto gap = [&] { return random_.OneIn(2) ? " " : ""; };
  const auto product = [&](bool whole) {
    std::string text = Primary(depth, whole);
    for (uint32_t i = random_.Below(3); i > 0; --i) {
      text += gap() + random_.Pick(Texts{"*", "/"}) + gap();
      text += Primary(depth, whole);
    }
    return text;
  };
  const auto sum = [&](bool whole) {
    std::string text = product(whole);
    for (uint32_t i = random_.Below(3); i > 0; --i) {
      text += gap() + random_.Pick(Texts{"+", "-"}) + gap();
      text += product(whole);
    }
    return text;
  };
  if (!random_.OneIn(4)) return sum(whole_only);
  std::string text = sum(true);
  for (uint32_t i = random_.Between(1, 2); i > 0; --i) {
    text += random_.Pick(Texts{" & ", " | "});
    text += sum(true);
  }
  return text;
}

std::string Networks::Relation() {
  const std::string left = Expression(2, random_.OneIn(2));
  return left + " " + random_.Pick(Texts{">", "<", ">=", "<=", "=", "<>"}) + " " + Expression(2, random_.OneIn(2));
}

// --- instruction lists ---

void Networks::Line(const std::string& text) {
  ++made_;
  std::string line = "  " + text;
  if (random_.OneIn(25)) line += " ; " + std::to_string(made_);
  if (random_.OneIn(60)) lines_.push_back("  REMARK \"remark " + std::to_string(made_) + "\"");
  lines_.push_back(line);
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
      if (word == "ANDI" && random_.OneIn(2)) word = "ANI";
      if (word == "ANDP" && random_.OneIn(2)) word = "ANP";
      if (word == "ANDF" && random_.OneIn(2)) word = "ANF";
      Line(word + " " + Bit());
    } else if (choice < 5) {
      Line(Edge("OR") + " " + Bit());
    } else if (choice < 7) {
      Logic(depth - 1);
      Line(random_.Pick(Texts{"ORB", "ANB", "ANDB"}));
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
  if (!random_.OneIn(4)) return kind + " " + address + ", " + preset;
  const size_t letters = kind.starts_with("TP") ? 2 : 3;  // TON, TOF, TP, then the unit
  return kind.substr(0, letters) + " " + address + ", " + kind.substr(letters) + ", " + preset;
}

std::string Networks::Compare() {
  if (random_.OneIn(3)) return "COMP " + (random_.OneIn(3) ? "\"" + Relation() + "\"" : Relation());
  return random_.Pick(Texts{"EQ", "NE", "GT", "GL", "GE", "LT", "LE"}) + " " + Number() + ", " + Number();
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
      return random_.Pick(Texts{"WTOB", "WIOB"}) + " " + Whole() + ", " +
             Address(random_.Pick(Texts{"%B0", "%B490", "%Q0", "%Q400", "%B1969"})) + ", " + std::to_string(count);
    }
    case 7:
      return "OPRT " + (random_.OneIn(2) ? WholeResult() : RealResult()) + random_.Pick(Texts{" = ", " := ", "="}) +
             Expression(2, random_.OneIn(2));
    case 8:
      return Axis();
    case 9:
      if (section_ == Section::kOther && callees_.first <= callees_.last)
        return "CALL SR" + std::to_string(random_.Between(callees_.first, callees_.last));
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
  Piece network{"NETWORK L" + std::to_string(position + 10) + (random_.OneIn(3) ? " \"network\"" : ""), {}, ""};
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
      Line("LBL J" + std::to_string(target + 10));
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

std::string Networks::DrawnOutput() {
  ++made_;
  if (random_.OneIn(3)) return "{" + BlockWithoutQ() + "}";
  if (random_.OneIn(8)) return "{" + Timer() + "}";
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
        rows[0] += "--{" + Timer() + "}";
        break;
      case 1:
        rows[0] += "--{" + Compare() + "}";
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
  return {"LADDER\n" + Joined(rows) + "\nEND_LADDER", {}, ""};
}

}  // namespace plcxx::reference::host50_random
