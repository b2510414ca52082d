// What stands in a source becomes a comment that is one line and hides nothing.

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace plcxx::emit::print
