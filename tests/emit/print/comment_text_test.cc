// What stands in a source becomes a comment that is one line and hides nothing.

#include <gtest/gtest.h>

#include <string>

#include "transpiler/emit/print/cpp_printer.h"

namespace plcxx::emit::print {
namespace {

TEST(CommentText, CannotLeaveItsLine) {
  EXPECT_EQ(CommentText("a\\"), "a\\.");
  EXPECT_EQ(CommentText("  a\tb  "), "a b");
  EXPECT_EQ(CommentText("a\r\nb"), "a b");
  EXPECT_EQ(CommentText("   "), "");
}

TEST(CommentText, KeepsLettersAndDropsDirectionMarks) {
  EXPECT_EQ(CommentText("Смазка"), "Смазка");
  EXPECT_EQ(CommentText("a\xE2\x80\xAE"
                        "b"),
            "ab");  // right-to-left override
}

TEST(CommentText, WhatIsNoTextIsAQuestionMark) {
  EXPECT_EQ(CommentText("a\xEF\xBF\xBD"
                        "b"),
            "a?b");
  // What is left of a character whose end is missing is dropped, and nothing behind the text is read.
  EXPECT_EQ(CommentText("a\xD0"), "a");
  EXPECT_EQ(CommentText("a\xE2\x82"), "a");
}

TEST(CppBytes, BytesThatAreNoAsciiAreThreeDigitsOfEight) {
  EXPECT_EQ(CppBytes(""), "\"\"");
  EXPECT_EQ(CppBytes("a7~\x7F"), "\"a7~\x7F\"");
  EXPECT_EQ(CppBytes("\x80"
                     "1\xFF"),
            R"("\2001\377")");
  EXPECT_EQ(CppBytes("\x8A\xAF\xD3"), R"("\212\257\323")");
  EXPECT_EQ(CppBytes("\"\\\x01"), R"("\"\\")");
}

// Read as three bytes, the first of these would be a direction mark.
TEST(CommentText, CharactersOfFourBytesStayWhole) {
  for (const std::string text : {"\xF0\x98\x9C\x80", "\xF0\x9F\x98\x80", "\xF4\x8F\xBF\xBD"}) {
    EXPECT_EQ(CommentText(text), text);
    EXPECT_EQ(CommentText("a" + text + " b"), "a" + text + " b");
  }
}

/// UTF-8, up to three bytes.
std::string Utf8(unsigned code) {
  const auto byte = [](unsigned bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
}

TEST(CommentText, DropsWhatControlsOrHidesAndNothingBesideIt) {
  for (const unsigned code :
       {0x01u, 0x1Fu, 0x7Fu, 0x80u, 0x9Fu, 0x61Cu, 0x200Eu, 0x200Fu, 0x2028u, 0x202Eu, 0x2066u, 0x2069u, 0xFEFFu}) {
    EXPECT_EQ(CommentText("a" + Utf8(code) + "b"), "ab") << code;
  }
  for (const unsigned code :
       {0x21u, 0x7Eu, 0xA0u, 0x61Bu, 0x61Du, 0x200Du, 0x2010u, 0x2027u, 0x202Fu, 0x2065u, 0x206Au, 0xFEFEu, 0xFF00u}) {
    EXPECT_EQ(CommentText("a" + Utf8(code) + "b"), "a" + Utf8(code) + "b") << code;
  }
}

// Of a text of the program: what would end the literal is escaped, what controls is dropped.
TEST(CppString, IsOneLiteral) { EXPECT_EQ(CppString("a\"b\\c\x1F\x20\n"), "\"a\\\"b\\\\c \""); }
TEST(CppString, HasNoTrigraph) {
  EXPECT_EQ(CppString("?a?\?/??\?"), R"("?a?\?/?\?\?")");
  EXPECT_EQ(CppString("\"?\?"), R"("\"?\?")");
}

}  // namespace
}  // namespace plcxx::emit::print
