// Where State keeps what the program touches.

#include "transpiler/emit/layout/layout.h"

#include <gtest/gtest.h>

#include "transpiler/ir/reader.h"

namespace plcxx::emit::layout {
namespace {

constexpr std::string_view kDeclarations = R"(program "p" test
space A 32 volatile little host_visible "outputs"
space T 4 retentive little host_visible "kept"
space system 8 volatile little "times"
state T5 on_delay_timer
state C5 ring_counter
state P6 one_shot
place a bit A[0].0
place b bit A[0].1
place c bit A[0].2
place d bit A[1].0
place W bit A[2].3
place WORD i8 A[2]
place V i8 A[3]
place KEPT bit T[1].4
place KEPT_WORD i8 T[2]
place T5U bit field T5 done
place P6 bit field P6 pulse
place now i32 system[0]
host fault (kind : i8 = (LOW, HIGH), index : i32) "a diagnostic"
)";

TEST(Layout, OffsetsAreThoseOfTheStruct) {
  const ir::Program program =
      ir::ReadOrDie(std::string(kDeclarations) +
                    "routine fast fast {\n  body {\n%0 = load a\nstore W %0\n%1 = load WORD\nstore V %1\n"
                    "%2 = load now\nstore now %2\n}\n}\n");
  const Layout layout = MakeLayout(program);
  ASSERT_EQ(layout.members.front().name, "retentive");
  EXPECT_EQ(layout.members.front().element_bytes, 8u);  // the hash and four bytes
  EXPECT_EQ(layout.members[1].name, "word32");
  EXPECT_EQ(layout.members[1].offset, 8u);
  EXPECT_EQ(StructBytes(ir::StateKind::kOnDelayTimer), 12u);
  EXPECT_EQ(StructBytes(ir::StateKind::kTextInbox), 34u);
  EXPECT_EQ(layout.size % 4, 0u);
}

TEST(Layout, OneRetentiveByteIsKept) {
  const ir::Program program = ir::ReadOrDie(R"(program "p" test
space T 1 retentive little host_visible "kept"
place t i8 T[0]
routine fast fast {
  body {
    %0 = load t
    store t %0
  }
}
)");
  ASSERT_EQ(MakeLayout(program).members.front().name, "retentive");
  EXPECT_EQ(MakeLayout(program).size, 8u);
}

/// Storage of the first place, which no instruction touches, when a declaration stands behind it.
Storage StorageOfNamed(const std::string& declaration) {
  const ir::Program program = ir::ReadOrDie(std::string(kDeclarations) + declaration);
  return MakeLayout(program).places.front().storage;
}

TEST(Layout, WhatOnlyTheScheduleOrAMessageNamesHasRoom) {
  EXPECT_EQ(StorageOfNamed(""), Storage::kNone);
  EXPECT_EQ(StorageOfNamed("schedule slow_done a\n"), Storage::kBit);
  EXPECT_EQ(StorageOfNamed("schedule fast_done a\n"), Storage::kBit);
  EXPECT_EQ(StorageOfNamed("schedule retain_at_power_off a\n"), Storage::kBit);
  EXPECT_EQ(StorageOfNamed("message_word a\n"), Storage::kBit);
}

}  // namespace
}  // namespace plcxx::emit::layout
