// Spells an Emittable as C++ files. It never looks ahead, invents a name or widens a type.
//
// Every effect of a function is spelled in it exactly once: what the lines say is counted while they are written, and
// any other count is a fault of plcxx.
//
// What the pieces of PrintCpp share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/source/source.h"

namespace plcxx::emit::print {

/// A line of the source made safe for a C++ comment: no control or direction characters, no backslash at the end.
std::string CommentText(std::string_view text);

/// A C++ string literal of a text without control characters.
std::string CppString(std::string_view text);
/// The same for bytes that are no UTF-8: what is not ASCII is an octal escape.
std::string CppBytes(std::string_view bytes);

// The pieces of PrintCpp, one file each.
std::string PrintHeader(const Emittable& emittable);
std::string PrintTags(const Emittable& emittable);
std::string PrintState(const Emittable& emittable);
OutputFile PrintPart(const Emittable& emittable, const source::SourceManager& sources, uint32_t part);
/// A part whose #line directives lead to the statements of the source, and back to the file itself.
OutputFile WithLineDirectives(const OutputFile& file, const ir::Program& program, const source::SourceManager& sources);

/// Text of C++, and the instructions whose effects it spells.
struct Text {
  std::string chars;
  std::vector<ir::InstId> effects = {};

  Text() = default;
  Text(std::string of) : chars(std::move(of)) {}
  Text(std::string_view of) : chars(of) {}
  Text(const char* of) : chars(of) {}
  Text& operator+=(const Text& more);
  friend Text operator+(Text left, const Text& right) { return std::move(left += right); }
};
/// The text, which spells this instruction too.
Text Spelled(Text text, ir::InstId effect);

/// The C++ expression of a value; locals by their names.
struct Spelling {
  Text text;
  ir::Precedence precedence = ir::Precedence::kPrimary;
};
/// Where a long expression may be broken; the statement printer replaces it by a blank or a line end.
constexpr char kBreak = '\x01';
Spelling Spell(const Emittable& emittable, ir::ValueId value);
/// As Spell, but a double word that C++ would compute in int says its type: "static_cast<uint32_t>(a & b)".
Text SpellInItsType(const Emittable& emittable, ir::ValueId value);
/// A number that is a condition, and has its text.
bool IsSpelledAsBool(const Emittable& emittable, ir::ValueId value);
/// Whether GCC takes a choice between two constants for one that its type might not hold.
bool IsChoiceByOneBit(const Emittable& emittable, const ir::Inst& choice);
/// A place as it is read and written: "m[U4A8]", "s"; of an indexed one, its element `index`.
Spelling SpellPlace(const Emittable& emittable, ir::PlaceId place, ir::ValueId index);
/// A whole number as the source spells it, in base 10 or 16: "500", "0x20".
std::string IntegerText(uint64_t value, uint32_t base);
/// The raw bits of a value as a decimal constant: "true", "40000u", "1.5F".
std::string ConstantText(ir::Type type, uint64_t value);
/// An element of an array member of State by its name, or by the name of its stretch: "U4A8", "DB100 + 3".
std::string ElementName(const Emittable& emittable, layout::Storage storage, uint32_t index);
/// What a local's name stands for; the same as Spell for a value without local.
Spelling SpellDefinition(const Emittable& emittable, ir::ValueId value);

/// What the lines of one function spell.
class SpelledEffects {
 public:
  void Add(const Text& text) { spelled_.insert(spelled_.end(), text.effects.begin(), text.effects.end()); }
  /// Fails unless the function's text has each of its effects once, and none of another function.
  void CheckOnce(const Emittable& emittable, const std::vector<Piece>& function);

 private:
  std::vector<ir::InstId> spelled_;
};

}  // namespace plcxx::emit::print
