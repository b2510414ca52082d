// The words of a program's files, and what each of them names: a definition of the source, a place in memory, or both.
//
// In: an analysis of the texts as they are, and one that gives names their meaning (the same, or the last without
// errors). A word belongs to the definition with its name whose scope is the smallest around it; an address, and a name
// that stands for one, belong to the bits that they name. Not its job: texts for people (hover.cc).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/editing.h"
#include "transpiler/lsp/analysis.h"

namespace plcxx::lsp {

inline constexpr uint32_t kNoDefinition = 0xFFFFFFFF;

/// Bits of a space, a field of an instance, or a cell of the control.
struct Bits {
  enum class Of : uint8_t { kSpace, kInstance, kCell };
  Of of = Of::kSpace;
  uint32_t number = 0;           // of the space, the instance
  uint64_t first = 0, last = 0;  // half open
  bool operator==(const Bits&) const = default;
};
Bits BitsOf(const ir::Place& place);
bool Overlap(const Bits& a, const Bits& b);

struct Target {
  uint32_t definition = kNoDefinition;  // index into Names::definitions
  std::optional<Bits> bits;
  bool operator==(const Target&) const = default;
  bool known() const { return definition != kNoDefinition || bits.has_value(); }
};

class Names {
 public:
  /// Both outlive it.
  Names(Analysis& analysis, const Analysis& meaning);

  const std::vector<dialects::Definition>& definitions() const { return definitions_; }
  const dialects::Editing& editing() const { return editing_; }
  const ir::Program& program() const { return meaning_.program(); }
  /// By place.
  const std::vector<dialects::EditorToken>& TokensOf(source::FileId file) const { return tokens_[file.index]; }
  uint32_t files() const { return static_cast<uint32_t>(tokens_.size()); }
  /// The word at a place or right before it; null: none.
  const dialects::EditorToken* TokenAt(source::FileId file, source::Offset at) const;
  std::string_view TextOf(const dialects::EditorToken& token) const;
  Target TargetOf(const dialects::EditorToken& token) const;
  /// Every word that means the same: one definition, or the same bits by whatever name.
  std::vector<source::Range> MentionsOf(const Target& target) const;
  /// The part of a word that is the name.
  source::Range NamePartOf(const dialects::EditorToken& token) const;
  std::optional<dialects::Location> Locate(std::string_view text) const;
  /// The smallest routine around a place; kNoDefinition: none.
  uint32_t RoutineAt(source::Offset at) const;
  /// The definitions that are known at a place.
  bool IsVisible(const dialects::Definition& definition, source::Offset at) const;

 private:
  void ReadDefinitions();
  source::Range InFirstCopy(source::Range range) const;
  uint32_t DefinitionOf(const dialects::EditorToken& token) const;
  std::optional<Bits> BitsOfText(std::string_view text) const;

  Analysis& analysis_;
  const Analysis& meaning_;
  const ir::NameIndex index_{meaning_.program()};
  const dialects::Editing& editing_;
  std::vector<dialects::Definition> definitions_;
  std::vector<std::vector<dialects::EditorToken>> tokens_;  // by FileId
  std::unordered_map<std::string, std::vector<uint32_t>> by_key_;
  mutable std::unordered_map<std::string, std::optional<Bits>> bits_;  // by spelling
};

}  // namespace plcxx::lsp
