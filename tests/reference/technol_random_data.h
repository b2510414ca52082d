// Declarations for random programs of dialect technol: cells, arrays, structures and bits that only one program has.
//
// In: the draws, and how numbers are spelled. Out: lines for its DATA block, and what its code may name.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tests/reference/awkward_names.h"
#include "tests/reference/random_program.h"

namespace plcxx::reference::technol_code {

/// What code may name. `any` are bases of addresses: at least eight more bytes of the segment lie behind each.
struct Cells {
  std::vector<std::string> bytes, words, longs, any, bits;
};

class RandomData {
 public:
  using Spell = std::function<std::string(const std::vector<std::string>& any)>;
  using Literal = std::function<std::string(uint64_t value)>;
  RandomData(Random& random, Spell spell, Literal literal, AwkwardNames& awkward)
      : random_(random), spell_(std::move(spell)), literal_(std::move(literal)), awkward_(awkward) {}

  const Cells& cells() const { return cells_; }

  /// In front of cells that are always there: `any` reaches into those.
  std::vector<std::string> Lines() {
    for (uint32_t k = random_.Below(3); k > 0; --k) Structure();
    for (uint32_t k = random_.Below(12); k > 0; --k) Cell();
    return std::move(lines_);
  }

 private:
  std::string NewName() {
    static const std::array<const char*, 8> kStems = {"_x",     "?q",  "@",       "Z",
                                                      "CITAC_", "k__", "POLOHA?", "Dlouhe_Jmeno_Jako_Z_Prirucky_"};
    const std::string awkward = random_.OneIn(3) ? awkward_.Next(random_) : "";
    return awkward.empty() ? kStems[random_.Below(kStems.size())] + std::to_string(names_++) : awkward;
  }

  static const char* Directive(uint32_t width) { return width == 8 ? "DB" : width == 16 ? "DW" : "DD"; }
  uint32_t Width() { return 8u << random_.Below(3); }
  std::vector<std::string>& Of(uint32_t width) {
    return width == 8 ? cells_.bytes : width == 16 ? cells_.words : cells_.longs;
  }

  std::string Value(uint32_t width) {
    const uint64_t all = (uint64_t{1} << width) - 1;
    switch (random_.Below(6)) {
      case 0:
        return spell_({"0", "?"});
      case 1:
        return literal_(all);
      case 2:
        return spell_({std::to_string(all / 2 + 1), "-" + std::to_string(all / 2 + 1)});
      case 3:
        return spell_({"66", "'B'", "(6 SHL 3)+18"});
      default:
        return literal_(random_.Next() & all & (random_.OneIn(2) ? all : 15));
    }
  }
  std::string Values(uint32_t width, uint32_t count) {
    std::string text;
    for (uint32_t i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + Value(width);
    return text;
  }

  /// Its fields are names of offsets: any address may have one behind it.
  void Structure() {
    const std::string name = NewName();
    lines_.push_back(name + spell_({" STRUC", " STRUCT"}));
    structures_.push_back({name, {}});
    for (uint32_t i = random_.Between(1, 5); i > 0; --i) {
      const std::string field = NewName();
      const uint32_t width = Width();
      const bool is_array = random_.OneIn(5);
      lines_.push_back(field + " " + Directive(width) + " " + (is_array ? "2 DUP (?)" : Value(width)));
      structures_.back().fields.push_back({field, width});
    }
    if (random_.OneIn(4)) lines_.emplace_back("  DB ?");
    lines_.push_back(name + " ENDS");
  }

  void Cell() {
    const std::string name = NewName();
    const uint32_t width = Width();
    const std::string colon = spell_({": ", " ", ":\t"});
    switch (random_.Below(7)) {
      case 0: {  // bits, some of them without a name
        std::string text = name + ": DFM ";
        for (uint32_t i = 0, count = random_.Between(1, 8); i < count; ++i) {
          if (i != 0) text += ",";
          if (random_.OneIn(5)) continue;
          cells_.bits.push_back(NewName());
          text += cells_.bits.back();
        }
        lines_.push_back(text);
        cells_.bytes.push_back(name);
        break;
      }
      case 1:
        lines_.push_back(name + colon + "DS " + std::to_string(width / 8));
        Of(width).push_back(name);
        break;
      case 2:
        lines_.push_back(name + colon + "DS " + std::to_string(random_.Between(5, 40)));
        break;
      case 3: {
        const uint32_t count = random_.Between(2, 6);
        lines_.push_back(name + colon + Directive(width) + " " + Values(width, count));
        Of(width).push_back(name);
        break;
      }
      case 4:
        lines_.push_back(name + colon + "DB " + spell_({"82,85,75,65", "'RUKA'", "'R','UK','A'"}) + "," + Value(8));
        break;
      case 5:
        if (!structures_.empty()) {
          const StructureInfo& structure = random_.Pick(structures_);
          const bool several = random_.OneIn(4);
          lines_.push_back(name + colon + structure.name + (several ? " 3 DUP (<>)" : spell_({" <>", " < >", "<>"})));
          for (const Field& field : structure.fields) Of(field.width).push_back(name + "." + field.name);
          break;
        }
        [[fallthrough]];
      default:
        lines_.push_back(name + colon + Directive(width) + " " + Value(width));
        Of(width).push_back(name);
        break;
    }
    cells_.any.push_back(name);
    if (!structures_.empty() && random_.OneIn(2)) {
      const StructureInfo& structure = random_.Pick(structures_);
      const Field& field = random_.Pick(structure.fields);
      const std::string base =
          random_.OneIn(2) ? "LABEL_MEM" : "(LABEL_MEM+" + std::to_string(random_.Below(960)) + ")";
      Of(field.width).push_back(base + "." + field.name);
    }
  }

  struct Field {
    std::string name;
    uint32_t width = 8;
  };
  struct StructureInfo {
    std::string name;
    std::vector<Field> fields;
  };

  Random& random_;
  Spell spell_;
  Literal literal_;
  Cells cells_;
  std::vector<std::string> lines_;
  std::vector<StructureInfo> structures_;
  AwkwardNames& awkward_;
  uint32_t names_ = 0;
};

}  // namespace plcxx::reference::technol_code
