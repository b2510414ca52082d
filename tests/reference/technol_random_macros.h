// Macros for random programs of dialect technol (9.7): definitions, calls, and what a call stands for.
//
// A macro is a list of steps, each of which loads what it needs. Its words are fixed or parameters; an argument may be
// left out, be joined to a word by "&", stand in brackets, or go on into a macro that is called inside.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/reference/random_program.h"

namespace plcxx::reference::technol_code {

struct MacroCall {
  std::string text, expanded;  // a call, and the lines that it stands for
  bool loads_dr = false, loads_rlo = false;
  bool has_label = false;
};

class RandomMacros {
 public:
  using Spell = std::function<std::string(const std::vector<std::string>& any)>;
  RandomMacros(Random& random, Spell spell) : random_(random), spell_(std::move(spell)) {}

  bool empty() const { return macros_.empty(); }

  std::vector<Piece> Definitions() {
    std::vector<Piece> pieces;
    for (uint32_t count = random_.Below(4); count > 0; --count) pieces.push_back(Define());
    return pieces;
  }

  MacroCall Call() {
    const Macro& macro = random_.Pick(macros_);
    MacroCall call;
    call.text = macro.name;
    std::vector<std::string> arguments;
    for (size_t i = 0; i < macro.parameters.size(); ++i) {
      arguments.push_back(Argument(macro.kinds[i]));
      call.text += (i == 0 ? " " : spell_({",", " , ", ", "})) + arguments.back();
    }
    while (call.text.ends_with(",") || call.text.ends_with(" ")) call.text.pop_back();
    Expand(macro, arguments, call);
    if (!call.expanded.empty() && call.expanded[0] == ' ') call.expanded.erase(0, call.expanded.find_first_not_of(' '));
    return call;
  }

 private:
  enum class Kind : uint8_t { kCell, kNumber, kBit, kWrittenBit, kDigit, kNothing };
  /// "LOD {0}": what is between braces is a parameter's number.
  struct Line {
    std::string text;
    size_t callee = kNone;  // else text is its arguments
    std::vector<std::string> arguments = {};
  };
  struct Macro {
    std::string name;
    std::vector<std::string> parameters;
    std::vector<Kind> kinds;
    std::vector<Line> lines;
    bool loads_dr = false, loads_rlo = false;
    bool has_label = false;
  };
  static constexpr size_t kNone = static_cast<size_t>(-1);

  std::string Argument(Kind kind) {
    switch (kind) {
      case Kind::kCell:
        return "W" + std::to_string(random_.Below(3));
      case Kind::kNumber:
        return random_.OneIn(3) ? "(" + std::to_string(random_.Below(9)) + "+1)" : std::to_string(random_.Below(300));
      case Kind::kBit:
        return (random_.OneIn(3) ? "I" : "A") + std::to_string(random_.Below(8));
      case Kind::kWrittenBit:
        return "A" + std::to_string(random_.Below(8));
      case Kind::kDigit:
        return std::to_string(random_.Below(3));
      case Kind::kNothing:
        return "";
    }
    return "";
  }

  /// A word of the body: a parameter of this kind, or one that is always the same.
  std::string Word(Macro& macro, Kind kind) {
    if (random_.OneIn(3) && kind != Kind::kDigit && kind != Kind::kNothing) return Argument(kind);
    for (size_t i = 0; i < macro.kinds.size(); ++i) {
      if (macro.kinds[i] == kind && random_.OneIn(2)) return "{" + std::to_string(i) + "}";
    }
    if (macro.parameters.size() > 6) return Argument(kind);
    static const char* const kNames[] = {"P", "q", "_r", "HODNOTA", "?z", "@a", "X_1"};
    macro.parameters.push_back(kNames[macro.parameters.size()] + std::to_string(macros_.size()));
    macro.kinds.push_back(kind);
    return "{" + std::to_string(macro.parameters.size() - 1) + "}";
  }

  void Step(Macro& macro) {
    const auto line = [&](const std::string& text) { macro.lines.push_back({text}); };
    switch (random_.Below(macros_.empty() ? 4 : 5)) {
      case 0:
        line("LOD " + Word(macro, Kind::kCell));
        for (uint32_t i = random_.Below(3); i > 0; --i) {
          static const std::vector<std::string> kWords = {"AD", "SU", "AND", "OR", "XOR"};
          line(random_.Pick(kWords) + " CNST." + Word(macro, Kind::kNumber));
        }
        line("STO " + Word(macro, Kind::kCell));
        macro.loads_dr = true;
        break;
      case 1:
        line("LDR " + Word(macro, Kind::kBit));
        for (uint32_t i = random_.Below(3); i > 0; --i) {
          static const std::vector<std::string> kWords = {"LA ", "LO -", "LX ", "LA -"};
          line(random_.Pick(kWords) + Word(macro, Kind::kBit));
        }
        line("WR " + Word(macro, Kind::kWrittenBit));
        macro.loads_rlo = true;
        break;
      case 2: {  // joined to a word; one that is missing is empty
        const std::string digit = Word(macro, Kind::kDigit);
        line(std::string("LOD W") + (digit[0] == '{' ? "&" : "") + digit);
        const bool has_empty = macro.parameters.size() < 6 && random_.OneIn(2);
        line("STO W1" + (has_empty ? "&" + Word(macro, Kind::kNothing) : ""));
        macro.loads_dr = true;
        break;
      }
      case 3: {
        const std::string label = "@SKOK" + std::to_string(labels_++);
        line("LDR " + Word(macro, Kind::kBit));
        line((random_.OneIn(2) ? "JL0 " : "JL1 ") + label);
        line("FL 1," + Word(macro, Kind::kWrittenBit));
        line(label + ":");
        local_.push_back(label);
        macro.has_label = true;
        break;
      }
      default: {
        const size_t callee = random_.Below(static_cast<uint32_t>(macros_.size()));
        Line call{"", callee};
        for (const Kind kind : macros_[callee].kinds) call.arguments.push_back(Word(macro, kind));
        macro.lines.push_back(call);
        macro.loads_dr = macro.loads_dr || macros_[callee].loads_dr;
        macro.loads_rlo = macro.loads_rlo || macros_[callee].loads_rlo;
        macro.has_label = macro.has_label || macros_[callee].has_label;
        break;
      }
    }
  }

  Piece Define() {
    Macro macro;
    macro.name = "MAKRO_" + std::to_string(macros_.size());
    local_.clear();
    for (uint32_t steps = random_.Between(1, 3); steps > 0; --steps) Step(macro);
    Piece piece{macro.name + " MACRO", {}, "  ENDM"};
    for (size_t i = 0; i < macro.parameters.size(); ++i) piece.text += (i == 0 ? " " : ",") + macro.parameters[i];
    if (!local_.empty()) {
      piece.text += "\n  LOCAL ";
      for (size_t i = 0; i < local_.size(); ++i) piece.text += (i == 0 ? "" : ",") + local_[i];
    }
    for (const Line& line : macro.lines) {
      std::string text = line.text;
      if (line.callee != kNone) {
        text = macros_[line.callee].name;
        for (size_t i = 0; i < line.arguments.size(); ++i) text += (i == 0 ? " " : ",") + line.arguments[i];
      }
      const bool is_label = text.ends_with(':');
      piece.text += (is_label ? "\n" : "\n  ") + Filled(text, macro.parameters);
    }
    macros_.push_back(std::move(macro));
    return piece;
  }

  static std::string Filled(std::string text, const std::vector<std::string>& words) {
    for (size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at)) {
      const size_t end = text.find('}', at);
      const std::string& word = words[std::stoul(text.substr(at + 1, end - at - 1))];
      text.replace(at, end - at + 1, word);
      at += word.size();
    }
    return text;
  }

  void Expand(const Macro& macro, const std::vector<std::string>& arguments, MacroCall& call) {
    call.loads_dr = call.loads_dr || macro.loads_dr;
    call.loads_rlo = call.loads_rlo || macro.loads_rlo;
    call.has_label = call.has_label || macro.has_label;
    const std::string unique = "_" + std::to_string(expansions_++);
    for (const Line& line : macro.lines) {
      if (line.callee != kNone) {
        std::vector<std::string> inner;
        for (const std::string& argument : line.arguments) inner.push_back(Filled(argument, arguments));
        Expand(macros_[line.callee], inner, call);
        continue;
      }
      std::string text = Filled(line.text, arguments);
      std::erase(text, '&');
      const size_t label = text.find("@SKOK");
      if (label != std::string::npos)
        text.insert(text.find(':', label) == std::string::npos ? text.size() : text.find(':'), unique);
      call.expanded += (call.expanded.empty() ? "" : "\n") + std::string(text.ends_with(':') ? "" : "  ") + text;
    }
  }

  Random& random_;
  Spell spell_;
  std::vector<Macro> macros_;
  std::vector<std::string> local_;
  uint32_t labels_ = 0, expansions_ = 0;
};

}  // namespace plcxx::reference::technol_code
