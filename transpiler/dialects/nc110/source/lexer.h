// The lexer of dialect nc110 (specification section 2): the text of one logic file to tokens and comments.
//
// Reports what is wrong with characters, literals and symbolic names; the token is then marked faulty, so that the
// parser says nothing more about its statement. Not its job: what a run means at its place (names of blocks).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/source/tokens.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/source/characters.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

enum class Homoglyphs : uint8_t { kReject, kAccept };

struct Token {
  TokenKind kind = TokenKind::kEndOfFile;
  Function function = Function::kDec;  // kFunction only
  bool first_on_line : 1 = false;
  bool lower_case : 1 = false;  // has a letter a-z
  bool faulty : 1 = false;      // already reported
  bool mapped : 1 = false;      // its text differs from the source: LexedFile::mapped
  source::Range range;
};

struct LexedFile {
  std::vector<Token> tokens;                     // the last one is kEndOfFile
  std::vector<Comment> comments;                 // place: kTrailing after a token of its line, else kLeading
  std::map<source::Offset, std::string> mapped;  // by the token's begin: look-alike letters replaced
};

LexedFile Lex(const source::SourceManager& sources, source::FileId file, Homoglyphs homoglyphs,
              diag::Engine& diagnostics);

/// The look-alike letters of one file: reported, or mapped with one warning.
class HomoglyphReader {
 public:
  HomoglyphReader(Homoglyphs mode, diag::Engine& diagnostics) : mode_(mode), diagnostics_(diagnostics) {}

  enum class Outcome : uint8_t { kMapped, kReported };
  /// `text` holds letters above 7EH and begins at `begin`. Writes the text with Latin letters to `mapped`.
  /// kReported: the caller says nothing more; `mapped` is empty where a letter is no look-alike at all (error 10).
  Outcome Read(std::string_view text, source::Offset begin, std::string& mapped);

 private:
  Homoglyphs mode_;
  bool warned_ = false;
  diag::Engine& diagnostics_;
};

/// The Latin letter, or the 3, that a Cyrillic one looks like; 0: none.
char LatinFor(char32_t letter);
/// "'%'"; without a picture for control characters.
std::string Picture(std::string_view text, source::CodePoint point);
/// Letters, digits and @ # . ' ? (specification 2.6).
bool IsNameCharacter(char c);

}  // namespace plcxx::nc110
