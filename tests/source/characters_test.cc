#include "transpiler/source/characters.h"

#include <gtest/gtest.h>

#include "transpiler/source/columns.h"

namespace plcxx::source {
namespace {

TEST(Characters, CodePoints) {
  EXPECT_EQ(FirstCodePoint("Ab").value, U'A');
  EXPECT_EQ(FirstCodePoint("泵x").value, U'泵');
  EXPECT_EQ(FirstCodePoint("泵x").length, 3u);
  EXPECT_EQ(FirstCodePoint("😀").value, U'😀');
  EXPECT_EQ(FirstCodePoint("\xFF").value, 0xFFu);
  EXPECT_EQ(FirstCodePoint("\xFFxy").length, 1u);
  EXPECT_EQ(CountCodePoints("a泵\xFF"), 3u);
  EXPECT_EQ(CountCodePoints(""), 0u);
  EXPECT_EQ(CodePointName(U'\\'), "U+005C");
  EXPECT_EQ(CodePointName(U'č'), "U+010D");
  EXPECT_EQ(CodePointName(U'😀'), "U+1F600");
}

TEST(Characters, Categories) {
  for (const char32_t c : U"aZäЯ泵א") {
    EXPECT_EQ(IsLetter(c), c != 0) << static_cast<uint32_t>(c);  // the literal ends with 0
  }
  for (const char32_t c : U"0_+ -.;٣") {
    EXPECT_FALSE(IsLetter(c)) << static_cast<uint32_t>(c);
  }
  EXPECT_TRUE(IsNumber(U'7'));
  EXPECT_TRUE(IsNumber(U'٣'));
  EXPECT_TRUE(IsMark(U'\u0301'));
  EXPECT_FALSE(IsMark(U'e'));
}

TEST(Characters, DisplayWidth) {
  EXPECT_EQ(DisplayWidth(U'a'), 1u);
  EXPECT_EQ(DisplayWidth(U'é'), 1u);
  EXPECT_EQ(DisplayWidth(U'泵'), 2u);
  EXPECT_EQ(DisplayWidth(U'Ａ'), 2u);  // fullwidth
  EXPECT_EQ(DisplayWidth(U'ｱ'), 1u);   // halfwidth
  EXPECT_EQ(DisplayWidth(U'\u0301'), 0u);
}

TEST(Columns, AreLettersAndNotBytes) {
  EXPECT_EQ(ColumnsOf("SHLIF"), 5u);
  EXPECT_EQ(ColumnsOf("ШЛИФ"), 4u);
  EXPECT_EQ(ColumnsOf("泵1"), 3u);
  EXPECT_EQ(ColumnsOf("\xFF"), 1u);
  EXPECT_EQ(LeftAligned("ШЛИФ", 6) + "|", "ШЛИФ  |");
  EXPECT_EQ(RightAligned("泵", 4), "  泵");
  EXPECT_EQ(LeftAligned("longer", 3), "longer");
}

}  // namespace
}  // namespace plcxx::source
