// Random programs of host50, from the grammar (section 3) and the ranges (section 5) of the specification: the parts of
// a program and its scenario. Networks come from host50_random_networks.h.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/host50_random_networks.h"
#include "tests/reference/host50_reference.h"

namespace plcxx::reference {
namespace {

using host50_random::Networks;
using host50_random::Texts;

class Generator {
 public:
  Generator(Random& random, ProgramSize size, Spelling spelling)
      : random_(random), size_(size), networks_(random, spelling) {}

  RandomProgram Run() {
    Options();
    const auto channels = program_.options.find("channels");
    networks_.ChooseHabits(channels == program_.options.end() ? 1 : static_cast<uint32_t>(channels->second[0] - '0'));
    const auto predefined = program_.options.find("predefined");
    if (predefined != program_.options.end()) networks_.UsePredefinedNames();
    long_times_ = random_.OneIn(50);
    const bool is_large = size_ == ProgramSize::kLarge;
    const uint32_t statements = is_large ? random_.Between(150, 600) : random_.Between(3, random_.OneIn(4) ? 150 : 40);
    const uint32_t subroutines = random_.OneIn(2) ? random_.Between(1, is_large ? 6 : 3) : 0;
    std::vector<Piece> parts;
    const bool has_slow = !random_.OneIn(20);  // W19
    Tables(parts);
    if (!has_slow || !random_.OneIn(3)) parts.push_back(Part("FAST", "END_FAST", {}, statements / 4, 10));
    if (has_slow)
      parts.push_back(Part("SLOW", "END_SLOW", {.first = 1, .last = subroutines, .most = 8}, statements / 2, 60));
    for (uint32_t i = 1; i <= subroutines; ++i) {
      parts.push_back(Part("SUB SR" + networks_.Padded(i - 1), "END_SUB",
                           {.first = i + 1, .last = subroutines, .most = 2}, statements / 4 / subroutines, 20));
    }
    Files(std::move(parts));
    Steps();
    return std::move(program_);
  }

 private:
  void Options() {
    std::map<std::string, std::string>& options = program_.options;
    const auto maybe = [&](const char* key, const char* value) {
      if (random_.OneIn(3)) options[key] = value;
    };
    maybe("tp", "IEC");
    maybe("rotq", "REVERSE");
    maybe("rotbase", "0");
    maybe("cnud", "HOLD");
    maybe("ftow", "ROUND");
    maybe("btow", "KEEP");
    maybe("axisbase", "0");
    maybe("edgeinit", "OFF");
    maybe("slices", "SLICED");
    if (random_.OneIn(10)) options["predefined"] = "ON";
    if (random_.OneIn(8)) options["channels"] = random_.Pick(Texts{"2", "2", "2", "3", "2", "8"});
    if (!random_.OneIn(4))
      options["slowdiv"] = random_.Pick(random_.OneIn(30)  ? Texts{"250", "1000"}
                                        : random_.OneIn(6) ? Texts{"50", "100"}
                                                           : Texts{"1", "2", "3", "5", "7", "20"});
  }

  /// Texts for the operator and the archive (3.1), and options in the source, which the scenario's own override.
  void Tables(std::vector<Piece>& parts) {
    if (random_.OneIn(4)) {
      static const Texts kKeys = {"BUILDER",   "MACHINE", "PROGRAM", "VERSION", "PCVERSION",
                                  "NCVERSION", "CREATED", "EDITED",  "AUTHOR",  "NOTE"};
      Piece title{"TITLE", {}, "END_TITLE"};
      const uint32_t first = random_.Below(8);
      for (uint32_t i = first; i < first + 3; ++i) title.body.push_back({kKeys[i] + " \"a \"\"b\"\"\"", {}, ""});
      parts.push_back(std::move(title));
    }
    if (random_.OneIn(4)) {
      parts.push_back({"ALARMS",
                       {{"%Q400 \"door\"", {}, ""},
                        {"%Q0401 WARNING \"oil\"", {}, ""},
                        {"%Q402 CAUTION \"air\"", {}, ""},
                        {"%Q499 notice \"end\"", {}, ""}},
                       "END_ALARMS"});
    }
    if (random_.OneIn(4)) {
      parts.push_back({"MCODES", {{"3 \"spindle\"", {}, ""}, {"008 \"coolant\"", {}, ""}}, "END_MCODES"});
    }
    static const std::vector<Texts> kOptions = {
        {"OPTION TP=IEC", "OPTION TP = MANUAL"},           {"OPTION ROTQ = REVERSE", "OPTION ROTQ=FORWARD"},
        {"OPTION ROTBASE=0", "OPTION ROTBASE=1"},          {"option cnud=hold", "OPTION CNUD=RING"},
        {"OPTION FTOW= ROUND", "OPTION FTOW=TRUNC"},       {"OPTION BTOW =KEEP", "OPTION BTOW=CLEAR"},
        {"OPTION EDGEINIT=OFF", "OPTION EDGEINIT=IMAGE"},  {"OPTION SLICES=SLICED", "OPTION SLICES=ATOMIC"},
        {"OPTION AXISBASE=0", "OPTION AXISBASE=1"},        {"SLOWDIV 4", "SLOWDIV 016"},
        {"OPTION PREDEFINED=ON", "OPTION PREDEFINED=OFF"}, {"CHANNELS 2", "CHANNELS 1"}};
    const uint32_t first = random_.Below(static_cast<uint32_t>(kOptions.size()));
    if (random_.OneIn(2)) parts.push_back({random_.Pick(kOptions[first]), {}, ""});
    if (random_.OneIn(4)) parts.push_back({random_.Pick(kOptions[(first + 5) % kOptions.size()]), {}, ""});
  }

  Piece Part(const std::string& head, const std::string& end, host50_random::Callees callees, uint32_t statements,
             uint32_t most_networks) {
    const std::string title = networks_.Spelled({"", "", " \"part of a machine\"", " ; comment"});
    Piece part{head + title, {}, end};
    networks_.Begin(head == "FAST" ? host50_random::Section::kFast : host50_random::Section::kOther, callees);
    const uint32_t begun = networks_.made();
    // The labels first: a jump may lead forward.
    const uint32_t count = random_.Between(1, std::max(1u, std::min(most_networks, statements / 3 + 1)));
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t wanted = begun + (i + 1) * statements / count;
      part.body.push_back(networks_.Network(i, count, wanted));
    }
    return part;
  }

  void Files(std::vector<Piece> parts) {
    const std::vector<Piece> symbols = {{"SYMBOLS", networks_.Symbols(), "END_SYMBOLS"}};
    const uint32_t count = random_.OneIn(2) ? 1 : random_.Between(2, 3);
    if (count > 1) program_.files.push_back({"names.il", symbols});
    for (uint32_t i = 0; i < count; ++i) program_.files.push_back({"part" + std::to_string(i) + ".il", {}});
    const size_t first = program_.files.size() - count;
    if (count == 1) program_.files[first].pieces = symbols;
    for (size_t i = 0; i < parts.size(); ++i) program_.files[first + i % count].pieces.push_back(std::move(parts[i]));
    for (RandomFile& file : program_.files) {
      file.pieces.insert(file.pieces.begin(), {"; part of a machine", {}, ""});
      file.line_end = networks_.Spelled({"\n", "\n", "\n", "\r\n"});
      file.head = networks_.Spelled({"", "", "", "\xEF\xBB\xBF"});
      file.tail = networks_.Spelled({"", "", "", "; a last line without its end"});
    }
  }

  // --- the scenario ---

  std::string Setting() {
    if (random_.OneIn(6)) return random_.Pick(networks_.floats()).substr(1) + ": " + Real();
    if (random_.OneIn(3)) {
      const Texts& from = random_.OneIn(4) ? networks_.words() : networks_.bits();
      const std::string& address = random_.Pick(from);
      const bool is_word = &from == &networks_.words();
      const std::string name =
          address.starts_with("%T") && !address.starts_with("%TM") ? "TM" + address.substr(2) : address.substr(1);
      const bool is_input = name[0] == 'I';
      if (is_input || random_.OneIn(4)) {
        return name + ": " + (is_word ? Whole() : std::to_string(random_.Below(2)));
      }
    }
    switch (random_.Below(8)) {
      case 0:
        return random_.Pick(Texts{"IW0", "IW110", "IW300", "W0", "W1", "W101", "W300", "QW5"}) + ": " + Whole();
      case 1:
        return random_.Pick(Texts{"IF0", "IF300", "F0", "F100", "F101"}) + ": " + Real();
      case 2:
        return random_.Pick(Texts{"B0", "B1", "B500", "B501", "Q0", "Q400", "Q1001"}) + ": " +
               std::to_string(random_.Below(2));
      case 3:
        if (random_.OneIn(3)) {
          return random_.Pick(Texts{"TM0.", "TM1.", "TM2.", "TM3.", "TM5.", "C0.", "C1."}) +
                 (random_.OneIn(2) ? "Q: " + std::to_string(random_.Below(2))
                                   : random_.Pick(Texts{"P: ", "V: "}) + std::to_string(random_.Below(9)));
        }
        return random_.Pick(Texts{"C0.V", "C1.V", "C100.V"}) + ": " + std::to_string(random_.Below(9));
      default:
        return random_.Pick(Texts{"I0", "I1", "I2", "I3", "I4", "I199", "I500", "I2000"}) + ": " +
               std::to_string(random_.Below(2));
    }
  }

  /// Halves and the ends of what a word holds, which a conversion rounds and limits.
  std::string Real() {
    return random_.Pick(Texts{
        "0.0",          "1.5",  "-2.25",         "1e10",          "-3e9",      "2147483648.0", "0.1", "1e-40", "nan",
        "inf",          "-0.0", "7.5",           "-0.5",          "0.5",       "0.49999997",   "2.5", "-2.5",  "-inf",
        "2147483520.0", "-7.5", "-2147483648.0", "-2147483904.0", "4194303.8", "-1.4999999",   "3.0", "2.0"});
  }

  std::string Whole() {
    if (random_.OneIn(5)) return random_.Pick(Texts{"2147483647", "-2147483648", "65536", "-1", "305419896"});
    return std::to_string(random_.Below(12));
  }

  void Steps() {
    const uint32_t steps = size_ == ProgramSize::kLarge ? 25 : random_.Between(8, 30);
    for (uint32_t i = 0; i < steps; ++i) {
      for (uint32_t sets = random_.Below(4); sets > 0; --sets) program_.steps.push_back("set: {" + Setting() + "}");
      if (random_.OneIn(25)) program_.steps.push_back("force: {" + Setting() + "}");
      if (random_.OneIn(25)) program_.steps.push_back("release: [I0, I1, B500, W0, Q0, C1.V]");
      if (random_.OneIn(20)) program_.steps.push_back("power_cycle: {}");
      if (long_times_ && random_.OneIn(8)) {
        program_.steps.push_back("run: {s: " + std::to_string(random_.Between(1, random_.OneIn(8) ? 62 : 3)) + "}");
        continue;
      }
      switch (random_.Below(5)) {
        case 0:
          program_.steps.push_back("run: {fast: " + std::to_string(random_.Between(1, 5)) + "}");
          break;
        case 1:
          program_.steps.push_back(
              "run: {ms: " + std::to_string(random_.OneIn(4) ? random_.Between(100, 260) : random_.Between(1, 20)) +
              "}");
          break;
        default:
          program_.steps.push_back("run: {slow: " + std::to_string(random_.Between(1, 6)) + "}");
          break;
      }
    }
  }

  Random& random_;
  ProgramSize size_;
  Networks networks_;
  bool long_times_ = false;
  RandomProgram program_;
};

}  // namespace

RandomProgram RandomHost50(Random& random, ProgramSize size, Spelling spelling) {
  return Generator(random, size, spelling).Run();
}

}  // namespace plcxx::reference
