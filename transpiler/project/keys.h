// The table of keys of plcxx.yaml (keys.def), as rows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::project {

enum class Section : uint8_t { kFile, kProgram, kWarnings, kTarget };

/// What may be the value of a key.
enum class Shape : uint8_t {
  kWord,               // anything in one word
  kWords,              // one word or a list of them
  kNumber,             // a whole number
  kFileName,           // letters, digits, '_', '-' and '.'
  kPath,               // of a file or a folder in the project
  kPaths,              // one, or a list of them
  kGlobs,              // likewise, with patterns
  kDialect,            // its name
  kEncoding,           // its name, or auto
  kLevel,              // of -O
  kFrequency,          // 168MHz
  kHost,               // own, or a host that plcxx writes
  kOptions,            // a map from names to words or lists of them
  kMacros,             // a map from names to words or to nothing, or a list of NAME and NAME=VALUE
  kWarningNames,       // codes of warnings, with or without the dialect
  kWarningNamesOrAll,  // likewise, or 'all'
  kWarnings,           // a map with the keys of Section::kWarnings
  kTargets,            // a map from targets to maps with the keys of Section::kTarget, or a list of targets
  kPrograms            // a list of maps with the keys of Section::kProgram
};

enum class Key : uint8_t {
#define PLCXX_PROJECT_KEY(Section, Id, Text, Shape, Meaning, Default) k##Id,
#include "transpiler/project/keys.def"
#undef PLCXX_PROJECT_KEY
};

struct KeyRow {
  Section section;
  Key key;
  std::string_view text;
  Shape shape;
  std::string_view meaning;      // Markdown
  std::string_view when_absent;  // Markdown
};

std::span<const KeyRow> Keys();

/// nullptr: there is none. Those of a program are also keys of the file.
const KeyRow* FindKey(Section section, std::string_view text);
/// All that FindKey finds.
std::vector<const KeyRow*> KeysOf(Section section);

/// The words that a shape allows; empty where others may be.
std::vector<std::string> WordsOf(Shape shape);

}  // namespace plcxx::project
