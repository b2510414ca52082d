// How often a loop is executed at most, as its message says it (specification 6.6), and which loops have no such
// number.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "hnc_lowered.h"

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;

/// What is reported of the loops of plc1() with these statements, from two rounds on.
std::vector<std::string> RoundsOf(const std::string& statements) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements(statements), {{"loop-warn", "1"}});
  std::vector<std::string> reported;
  for (const diag::Diagnostic& diagnostic : lowered.diagnostics.all()) {
    if (diagnostic.row->code == "hnc-W7" || diagnostic.severity == diag::Severity::kError) {
      reported.push_back(diagnostic.text);
    }
  }
  return reported;
}

struct Counted {
  std::string statements;
  uint32_t rounds;
};

void ExpectRounds(const std::vector<Counted>& loops) {
  for (const Counted& loop : loops) {
    const std::string text = "long loop: up to " + std::to_string(loop.rounds) + " rounds";
    EXPECT_THAT(RoundsOf(loop.statements), ElementsAre(text)) << loop.statements;
  }
}

// covers: HNC-244, HNC-249, HNC-260
TEST(HncRounds, OfConstants) {
  ExpectRounds({
      {"for (i = 0; i < 10; i++) a++;", 10},          {"for (i = 0; i <= 10; i++) a++;", 11},
      {"for (i = 10; i > 0; i--) a++;", 10},          {"for (i = 10; i >= 0; i--) a++;", 11},
      {"for (i = 0; 10 > i; i++) a++;", 10},          {"for (i = 0; 10 >= i; i++) a++;", 11},
      {"for (i = 10; 0 < i; i--) a++;", 10},          {"for (i = 10; 0 <= i; i--) a++;", 11},
      {"for (i = 0; !(i >= 10); i++) a++;", 10},      {"for (i = 0; !(i > 10); i++) a++;", 11},
      {"for (i = 0; !!(i < 10); i++) a++;", 10},      {"for (i = -5; i < 5; i++) a++;", 10},
      {"for (i = 5; i > -5; i -= 2) a++;", 5},        {"for (i = 0; i < 10; i += 3) a++;", 4},
      {"for (i = 0; i <= 9; i += 3) a++;", 4},        {"for (i = 10; i > 0; i -= 3) a++;", 4},
      {"for (i = 0; i < 10; i = i + 3) a++;", 4},     {"for (i = 0; i < 10; i = 3 + i) a++;", 4},
      {"for (i = 10; i > 0; i = i - 3) a++;", 4},     {"for (i = 0; i < 10; i -= -3) a++;", 4},
      {"for (i = 0; i != 10; i += 2) a++;", 5},       {"for (i = 10; i != 0; i -= 5) a++;", 2},
      {"for (i = 0; !(i == 6); i += 2) a++;", 3},     {"for (i = 8; i; i--) a++;", 8},
      {"for (c = 250; c != 4; c += 2) a++;", 5},      {"for (u = 65534; u != 2; u++) a++;", 4},
      {"for (u = 10; u; u += 65535) a++;", 10},       {"for (u = 10; u > 0; u += 65534) a++;", 5},
      {"for (c = 0; c < 200u; c++) a++;", 200},       {"for (c = 0; (int)c <= 254; c++) a++;", 255},
      {"for (i = 0; (long)i < 10L; i++) a++;", 10},   {"for (l = 0; l < 100000; l += 7) a++;", 14286},
      {"for (R[5] = 0; R[5] < 10; R[5]++) a++;", 10}, {"for (table[2] = 0; table[2] < 10; table[2]++) table[3]++;", 10},
  });
}

// covers: HNC-250, HNC-251, HNC-357
TEST(HncRounds, OfEachKindOfLoop) {
  ExpectRounds({
      {"i = 0; while (i < 10) i++;", 10},
      {"i = 0; while (i++ < 10) a++;", 10},
      {"i = 0; while (++i < 10) a++;", 9},
      {"n = 7; while (n--) a++;", 7},
      {"n = 7; while (--n > 0) a++;", 6},
      {"i = 0; do i++; while (i < 5);", 5},
      {"i = 0; do { i += 2; } while (i != 10);", 5},
      {"i = 7; do i--; while (i);", 7},
      {"n = 4; do a++; while (--n);", 4},
      {"n = 4; do a++; while (n--);", 5},
      {"n = 4; do a++; while (--n > 0);", 4},
      {"i = 0; again: i++; if (i < 5) goto again;", 5},
      {"\n//@loop_bound 12\nwhile (X[0]) a++;", 12},
      // The first change leads over the end of the type.
      {"c = 255; do c++; while (c < 10);", 11},
      {"u = 0; do u--; while (u > 65530);", 6},
      {"c = X[0]; do c++; while (c < 10);", 11},
      // Changed where another statement begins.
      {"i = 0; while (i < 10) if (i++ > 3) a++;", 10},
      {"i = 0; while (i < 10) switch (i++) { case 3: a++; }", 10},
      // Changed once, wherever a round goes.
      {"i = 0; while (i < 10) { if (b) { i++; continue; } i++; }", 10},
      {"i = 0; while (i < 10) { if (b) i += 2; else i = i + 2; }", 5},
      {"i = 0; while (i < 10) { if (b) { if (a) return; i++; } else i++; }", 10},
      {"i = 0; while (i < 10) { switch (b) { case 1: i++; break; default: i++; } }", 10},
      {"i = 0; while (i < 10) { if (b) goto over; i++; continue; over: i++; }", 10},
      {"i = 0; while (i < 10) { do { i++; } while (0); }", 10},
      {"i = 0; while (i < 10) b ? i++ : (i += 1);", 10},
      // A comma in the condition.
      {"i = 0; while (a++, i < 10) i++;", 10},
      {"i = 0; while (i++, i < 10) a++;", 9},
      {"i = 0; do a++; while (i++, i < 10);", 10},
      {"i = 0; while (i++, X[0] && i < 10) a++;", 9},
      {"i = 0; while (X[0] && (i++, i < 10)) a++;", 9},
      // The jump back leads to where one from above does.
      {"i = 0; if (X[0]) goto again; i = 2; again: i++; if (i < 5) goto again;", 5},
      {"i = 0; while (i < 10 && X[0]) i++;", 10},
      {"i = 0; while (X[0] && i < 10) i++;", 10},
      {"i = 0; while (X[0] && i < 10 && X[1]) i++;", 10},
      // The conjunct that fails first.
      {"i = 0; n = 0; while (i < 10 && n < 5) { i++; n++; }", 5},
      {"i = 0; n = 0; while (n < 5 && i < 10) { i++; n++; }", 5},
  });
  for (const char* once : {"i = 9; do i++; while (i < 5);", "for (i = 5; i < 5; i++) a++;",
                           "for (i = 5; i < 6; i++) a++;", "do a++; while (0);", "while (1) { a++; break; }",
                           // Every path of the body leaves: the condition is evaluated once at most.
                           "do { a++; break; } while (b);", "do { if (b) break; else return; } while (a);",
                           "while (X[0]) { a++; break; }", "for (; X[0]; i += b) { a++; return; }",
                           "do { for (i = 0; i < 1; i++) { if (b) continue; a++; } break; } while (X[0]);"}) {
    EXPECT_THAT(RoundsOf(once), testing::IsEmpty()) << once;
  }
}

// covers: HNC-246, HNC-247
TEST(HncRounds, OfRanges) {
  ExpectRounds({
      {"for (i = X[0]; i < 10; i++) a++;", 10},
      {"for (i = 0; i < X[0]; i++) a++;", 255},
      {"for (i = 0; i <= X[0]; i++) a++;", 256},
      {"for (i = 2; i < (X[0] & 7); i++) a++;", 5},
      {"for (i = X[0] & 7; i > 0; i--) a++;", 7},
      {"for (i = 0; i < n; i++) a++;", 32767},
      {"while (i < 10) i++;", 32778},
      {"n = X[0]; while (n--) a++;", 255},
      {"n = X[0]; while (--n > 0) a++;", 254},
      {"c = X[0]; while (c) c--;", 255},
      {"u = P[0] % 100; while (u) u--;", 99},
      {"i = P[0] % 100; while (i > 0) i -= 7;", 15},
      {"for (i = 0; i < P[0] / 1000; i++) a++;", 65},
      {"for (i = 0; i < P[0] >> 12; i++) a++;", 15},
      {"for (i = 0; i < (X[0] > 24 ? 24 : X[0]); i++) a++;", 24},
      {"for (i = 0; i < 10 - (X[0] & 3); i++) a++;", 10},
      {"for (i = 0; i < (X[0] & 3) - 1; i++) a++;", 2},
      {"for (i = 0; i < -(X[0] & 3) + 9; i++) a++;", 9},
      {"for (i = 0; i < ~(X[0] & 3) + 9; i++) a++;", 8},
      {"n = X[0] & 15; if (n > 10) n = 10; for (i = 0; i < n; i++) a++;", 10},
      {"if (n > 9) n = 9; for (i = 0; i < n; i++) a++;", 9},
      {"int k = X_i[0]; if (k < 3) k = 3; for (i = k; i < 9; i++) a++;", 6},
      {"if (n >= 9) return; for (i = 0; i < n; i++) a++;", 8},
      {"if (!(n < 9)) return; for (i = 0; i < n; i++) a++;", 8},
      {"if (n == 9) for (i = 0; i < n; i++) a++;", 9},
      {"if (n > 9 || b) return; for (i = 0; i < n; i++) a++;", 9},
      {"if (n < 9 && n > 3) for (i = n; i < 20; i++) a++;", 16},
      {"int k = X[0]; if (k) for (i = k; i < 20; i++) a++;", 19},
      // Known to be 0, and not 0 all the same: nothing is known of it then.
      {"int k = 0; if (k) for (i = k; i < 5; i++) a++;", 5},
      // Of a bit-field its width is known, and nothing that is known of all its bytes.
      {"union { int i; struct { int f : 4; } s; } v; v.i = 8; for (i = 4; i > v.s.f; i--) a++;", 12},
      {"union { int i; struct { int f : 4; } s; } v; if (v.i == 8) for (i = 4; i > v.s.f; i--) a++;", 12},
      {"struct { int f : 4; unsigned g : 5; } s; for (i = 7; i >= s.f; i--) a++;", 16},
      {"struct { int f : 4; unsigned g : 5; } s; for (i = 0; i < s.g; i++) a++;", 31},
      {"union { int i; unsigned u; } v; v.i = 8; for (i = 0; i < v.u; i++) a++;", 8},
      // What abs and labs give.
      {"for (i = 0; i < abs((X[0] & 7) - 9); i++) a++;", 9},
      {"for (i = abs((X[0] & 7) - 9); i < 9; i++) a++;", 7},
      {"for (i = abs(X[0] + 3); i < 9; i++) a++;", 6},
      {"for (i = abs(5 - X[0]); i < 9; i++) a++;", 9},
      {"if (n > -20) for (i = 0; i < 9 - abs(n); i++) a++;", 9},
      {"if (n > -32768 && n < 5) for (i = 0; i <= abs(n) - 1; i++) a++;", 32767},
  });
}

// covers: HNC-260
TEST(HncRounds, OfNestedLoopsAreMultiplied) {
  EXPECT_THAT(RoundsOf("for (i = 0; i < 4; i++) for (n = 0; n < 5; n++) a++;"),
              ElementsAre("long loop: up to 4 rounds", "long loop: up to 20 rounds"));
  // The outer counter is 3 at most.
  EXPECT_THAT(RoundsOf("int k; for (k = 0; k < 4; k++) for (n = 0; n < k; n++) a++;"),
              ElementsAre("long loop: up to 4 rounds", "long loop: up to 12 rounds"));
  EXPECT_THAT(RoundsOf("i = 0; while (i < 10) for (i++, n = 0; n < 5; n++) a++;"),
              ElementsAre("long loop: up to 10 rounds", "long loop: up to 50 rounds"));
  // One after the other they are not.
  EXPECT_THAT(RoundsOf("for (i = 0; i < 4; i++) a++; for (i = 0; i < 5; i++) a++;"),
              ElementsAre("long loop: up to 4 rounds", "long loop: up to 5 rounds"));
}

// covers: HNC-254, HNC-255, HNC-256
TEST(HncRounds, WhatIsNoProofIsRefused) {
  for (const char* loop : {
           // 6.6, 2: changed once in each round, by a constant, towards the limit.
           "for (i = 1; i < 100; i *= 2) a++;",
           "for (i = 1; i < 100; i <<= 1) a++;",
           "for (i = 0; i < 100; i += n) a++;",
           "for (i = 0; i < 100; i += 0) a++;",
           "for (i = 0; i < 100; i = n + 1) a++;",
           "for (i = 0; i < 100; i = 5 - i) a++;",
           "for (i = 0; i < 100; i = i * 2) a++;",
           "for (i = 0; i < 100; i--) a++;",
           "for (i = 0; i < 100; a++) b++;",
           "for (i = 0; i < 100; i++) { if (b) i++; }",
           "for (i = 0; i < 100; i++) i--;",
           "i = 0; while (i < 100) { if (b) i++; else a++; }",
           "i = 0; while (i < 100) { switch (b) { case 1: i++; } }",
           "i = 0; while (i < 100) { b && i++; }",
           "i = 0; while (i < 100) { b ? i++ : 0; }",
           "i = 0; while (i < 100) { for (n = 0; n < 5; n++) i++; }",
           "i = 0; while (i < 100) { if (b) goto on; i++; on: a++; }",
           "again: { int k = 0; k++; if (k < 5) goto again; }",
           "i = 0; again: if (b) i++; if (i < 5) goto again;",
           "i = 0; again: i++; if (i -= b) if (i < 5) goto again;",
           "i = 0; again: i++; if (i < 5) { i = b; goto again; }",
           // 6.6, 1: an integer variable or a cell that nothing else changes.
           "float f; for (f = 0; f < 100; f++) a++;",
           "struct { int f : 5; } s; for (s.f = 0; s.f < 9; s.f++) a++;",
           "for (table[b & 7] = 0; table[b & 7] < 9; table[b & 7]++) a++;",
           "for (R_ui[2] = 0; R_ui[2] < 10; R[4]++) a++;",
           "for (R_ui[2] = 0; R_ui[2] < 10; R_ui[2]++) R[5] = 0;",
           "for (table[2] = 0; table[2] < 10; table[2]++) table[b & 7] = 0;",
           "union { long l; float f; } v; v.l = 0; while (v.l != 5) v.f++;",
           "union { long l; float f; } v; v.l = 0; while (v.l != 5) v.f += 1;",
           "union { int i; struct { int f : 5; } s; } v; v.i = 0; while (v.i < 100) v.s.f++;",
           "union { int i; struct { unsigned f : 5; } s; } v; for (v.i = 0; v.i < 100; v.s.f = v.s.f + 1) a++;",
           "union { int i; struct { int f : 5; } s; } v; for (v.i = 0; v.i < 20; v.i = v.s.f + 1) a++;",
           "union { int i; struct { int f : 5; int g : 11; } s; } v; for (v.i = 9; v.i > 0; v.i = v.s.g - 1) a++;",
           "n = 5; while ((float)n) n--;",
           // 6.6, 3: the limit.
           "for (i = 0; i < n; i++) n++;",
           "for (i = 0; i < n++; i++) a++;",
           "for (i = 0; i < table[3]; i++) table[3] = 5;",
           "for (i = 0; i < table[3]; i++) table[b & 7] = 5;",
           "for (i = 0; i < table[b & 7]; i++) table[2] = 5;",
           "for (i = 0; i < table[b & 7]; i++) b = 1;",
           // Neither a comparison nor a counter alone.
           "while (-i) i++;",
           "while (~i) i++;",
           "while (i + 1) i++;",
           "for (i = 1; i & 8; i++) a++;",
           "for (i = 0; i - 5; i++) a++;",
           "for (i = 9; i % 5; i--) a++;",
           "for (i = 1; i << 3; i++) a++;",
           "for (;;) { if (b) continue; break; }",
           "do { if (b) continue; break; } while (a);",
           "do { if (b) break; } while (a);",
           "while (X[0]) { if (b) continue; break; }",
           "while (X[0]) { if (b) break; }",
           "for (; X[0]; i++) { if (b) break; }",
           // abs of the least value is not positive: the limit is any number.
           "for (i = 0; i <= abs(n); i++) a++;",
           "for (i = 0; i <= abs(X[0] > 3 ? 5 : n); i++) a++;",
           // 6.6, 4: not past the end of the type.
           "for (i = 0; i <= n; i++) a++;",
           "for (i = 0; i < n; i += 2) a++;",
           "for (i = 0; i != n; i += 2) a++;",
           "for (u = 9; u >= 0; u--) a++;",
           "for (u = 9; u > 0; u -= 2) a++;",
           "for (c = 0; c < 256; c++) a++;",
           "for (c = 0; c <= 254; c += 2) a++;",
       }) {
    const std::vector<std::string> reported = RoundsOf(loop);
    EXPECT_TRUE(
        std::ranges::any_of(reported, [](const std::string& text) { return text.starts_with("unbounded loop"); }))
        << loop << testing::PrintToString(reported);
  }
  for (const char* loop : {
           "union { int i; unsigned u; } v; for (v.i = 0; v.i < 10; v.u++) a++;",
           "union { int i; unsigned u; } v; for (v.i = 0; v.i < 10; v.i = v.u + 1) a++;",
           "for (i = 0; i < table[3]; i++) table[2] = 5;",
           "for (i = 0; i < table[b & 7]; i++) a = 5;",
           "for (R_ui[2] = 0; R_ui[2] < 10; R_ui[2]++) R[6] = 0;",
           "for (table[2] = 0; table[2] < 10; table[2]++) table[1] = 0;",
           "for (i = 0; i < n; i++) a = n;",
           "for (c = 0; c < 255; c++) a++;",
           "for (u = 9; u > 1; u -= 2) a++;",
           // A continue of a loop inside is none of the loop that every path leaves.
           "for (;;) { for (i = 0; i < 5; i++) { if (b) continue; a++; } break; }",
           "while (1) { switch (a) { case 1: for (i = 0; i < 5; i++) { if (b) continue; a++; } } break; }",
           "for (;;) { if (a) { for (i = 0; i < 5; i++) { if (b) continue; a++; } } break; }",
           // A goto leaves, too.
           "for (;;) { a++; goto out; } out: b = 1;",
           "while (1) { if (a) goto out; else goto out; } out: b = 1;",
           "do { a++; goto out; } while (b); out: b = 1;",
       }) {
    EXPECT_THAT(Errors(loop), testing::IsEmpty()) << loop;
  }
}

// covers: HNC-254
TEST(HncRounds, AWayWithoutAChangeOrWithTwo) {
  const std::string twice = "unbounded loop: its counter is changed in two places",
                    missing = "unbounded loop: its counter is not changed on every path",
                    differs = "unbounded loop: its counter does not change by a constant";
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"i = 0; while (i < 9) { if (b) i++; i++; }", twice},
      {"i = 0; while (i < 9) { switch (b) { case 1: i++; default: i++; } }", twice},
      {"i = 0; while (i < 9) { if (b) goto over; i++; over: i++; }", twice},
      {"i = 0; while (i < 9) { switch (b) { case 1: i++; break; case 2: i++; } }", missing},
      {"i = 0; while (i < 9) { if (b) { i++; continue; } if (a) i++; }", missing},
      {"i = 0; while (i < 9) { again: i++; if (b) goto again; }", missing},
      {"i = 0; while (i < 9) { for (n = 0; n < 3; n++) i++; }", missing},
      {"i = 0; while (X[0] ? (i++, i < 9) : b) a++;",
       "unbounded loop: its condition does not compare a counter with a limit"},
      {"i = 0; while (i < 9 && (i++, b)) a++;", missing},
      {"i = 0; while (i++, i < 9) i++;", twice},
      {"i = 0; while (i < 9) { if (b) i++; else i += 2; }", differs},
      {"i = 0; while (i < 9) { if (b) i++; else i = 0; }", differs},
  };
  for (const auto& [loop, reason] : refused) {
    const std::vector<std::string> reported = RoundsOf(loop);
    EXPECT_THAT(reported, testing::Contains(reason)) << loop;
  }
}

// Each conjunct of a condition has a reason of its own: said is that of the one that came nearest to a proof, and of
// two that came as near that of the first.
TEST(HncRounds, TheReasonIsThatOfTheNearestProof) {
  struct Cause {
    std::string condition, body, reason;
    int step;
  };
  const std::vector<Cause> causes = {
      {"a + b > 0", "", "does not compare a counter with a limit", 0},
      {"b > 5", "", "nothing in it changes its counter", 1},
      {"i < 5", "i = i * 2;", "does not change by a constant", 2},
      {"i < 5", "if (b) i++;", "not changed on every path", 2},
      {"i < 5", "i++; i++;", "changed in two places", 2},
      {"n < a", "n++; a++;", "its limit changes in the loop", 3},
      {"u != 3", "u += 2;", "may step over the end of its type", 4},
  };
  for (const Cause& one : causes) {
    for (const Cause& other : causes) {
      if (&one == &other || one.condition == other.condition) continue;
      const std::string loop =
          "while (" + one.condition + " && " + other.condition + ") { " + one.body + " " + other.body + " }";
      const std::vector<std::string> reported = RoundsOf(loop);
      ASSERT_EQ(reported.size(), 1U) << loop;
      EXPECT_THAT(reported.front(), testing::HasSubstr((one.step >= other.step ? one : other).reason)) << loop;
    }
  }
}

}  // namespace
}  // namespace plcxx::hnc
