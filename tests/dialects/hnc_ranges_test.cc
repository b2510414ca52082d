// What is known of a number where it is an index (specification 6.6, 6.9): an array of just so many elements needs no
// check, one with an element less has one.
#include <string>
#include <vector>

#include "hnc_lowered.h"

namespace plcxx::hnc {
namespace {

struct Known {
  std::string before, index;
  uint32_t most;  // of the index; the least is 0
};

/// Whether an access to an array of so many elements is checked, behind these statements.
bool IsChecked(const std::string& before, const std::string& index, uint32_t elements) {
  const std::string text =
      "#include \"plc.h\"\nint a, b, g; unsigned u; long l; unsigned char c; struct { unsigned three : 3; int : 2; "
      "signed four : 4; "
      "unsigned char wide; } s;\nenum { LEAST, MOST = 6 }; union { unsigned char bytes[2]; int word; } both;\n"
      "int below_ten(int n) { if (n < 0) return 0; if (n > 9) return 9; return n; }\nint any(int n) { return n; }\n"
      "int five_to_nine(int n) { if (n < 5) return 5; if (n > 9) return 9; return n; }\nint falls_off(int n) { if (n > "
      "5) return 5; }\n"
      "void spoil() { g = P_i[1]; }\nint table[" +
      std::to_string(elements) +
      "];\nvoid plc1() { int n = P_i[0], k = 0, m = P_i[2]; int *p = &g; unsigned char d; long w; int *q; " + before +
      " table[" + index + "] = 1; }\nvoid init() { plc1_time = 16; plc2_time = 32; }\nvoid plc2() { }\n";
  LoweredProgram lowered;
  LowerInto(lowered, text);
  EXPECT_FALSE(lowered.diagnostics.HasErrors())
      << before << " " << index << ": " << testing::PrintToString(lowered.Reported());
  for (const std::string& line : lowered.Routine("plc1")) {
    if (line.find("record_fault") != std::string::npos) return true;
  }
  return false;
}

// covers: HNC-247, HNC-278
TEST(HncRanges, ArraysThatAreJustLongEnoughNeedNoCheck) {
  const std::vector<Known> rows = {
      // Types, and what computes.
      {"", "R[0]", 255},
      {"", "(unsigned char)a", 255},
      {"c = a;", "c", 255},
      {"", "X[0] & 7", 7},
      {"", "a & 7", 7},
      {"", "(int)(l & 7)", 7},
      {"", "P[0] % 100", 99},
      {"", "P[0] / 1000", 65},
      {"", "P[0] >> 12", 15},
      {"", "R[0] + R[1]", 510},
      {"", "R[0] * 2", 510},
      {"", "(R[0] & 3) * 5 + 1", 16},
      {"", "255 - R[0]", 255},
      {"", "(R[0] & 3) << 2", 12},
      {"", "(R[0] & 3) | 4", 7},
      {"", "(R[0] & 3) ^ 4", 7},
      {"", "-(R[0] & 7) + 7", 7},
      {"", "~(R[0] & 7) + 8", 7},
      {"", "!a", 1},
      {"", "a == b", 1},
      {"", "a < b", 1},
      {"", "a && b", 1},
      {"", "a || b", 1},
      {"", "(a && b) + (a || b)", 2},
      {"", "a ? 3 : 7", 7},
      {"", "a ? (R[0] & 3) : (R[1] & 12)", 12},
      {"", "u > 9 ? (a++, 3) : u", 9},
      {"", "u < 10 ? u : (a++, 3)", 9},
      {"", "u > 9 ? 3 : u", 9},
      {"", "u < 10 ? u : 3", 9},
      {"", "(a, b & 3)", 3},
      {"", "s.three", 7},
      {"", "s.four + 8", 15},
      {"", "s.wide", 255},
      {"", "MOST", 6},
      {"", "below_ten(a)", 9},
      {"n = below_ten(a);", "n", 9},
      {"", "five_to_nine(a) - 5", 4},
      {"", "falls_off(a)", 5},
      // Pointers.
      {"q = table; n = below_ten(a); q += n; *q = 2; n = 0;", "n", 9},
      {"n = below_ten(a); q = &table[n]; *q = 2; n = 0;", "n", 9},
      {"n = below_ten(a); q = table + n; q[2] = 2; n = 0;", "n", 11},
      {"n = below_ten(a); q = table + 4 + n; q--; *q = 2; n = 0;", "n", 12},
      {"n = below_ten(a) - 3; q = table + 4; q += n; *(q - 1) = 2; n = 0;", "n", 9},
      // Assignments and steps.
      {"n = 3;", "n", 3},
      {"n = 3; n += 4;", "n", 7},
      {"n = 3; n++;", "n", 4},
      {"n = 3;", "n++", 3},
      {"n = 3;", "++n", 4},
      {"n = 3;", "n--", 3},
      {"n = 3;", "--n", 2},
      {"n = R[0]; n -= n & 1;", "n & 255", 255},
      {"", "(n = R[0] & 15)", 15},
      {"k = (n = 5);", "k", 5},
      // Conditions.
      {"if (n < 0 || n > 9) return;", "n", 9},
      {"if (n > 9 || n < 0) return;", "n", 9},
      {"if (n < 0) return; if (n >= 10) return;", "n", 9},
      {"if (!(n >= 0 && n <= 9)) return;", "n", 9},
      {"if (n < 0) n = 0; if (n > 9) n = 9;", "n", 9},
      {"if (n < 0) n = 0; else if (n > 9) n = 9;", "n", 9},
      {"n = n < 0 ? 0 : n > 9 ? 9 : n;", "n", 9},
      {"if (n >= 0 && n < 10)", "n", 9},
      {"if (0 <= n && 10 > n)", "n", 9},
      {"if (n == 4)", "n", 4},
      {"if (4 == n)", "n", 4},
      {"if (n != 4) return;", "n", 4},
      {"if (n) return;", "n", 0},
      {"if (!n)", "n", 0},
      {"if (n < 0) return; if (n < 10) a = 1; else n = 3;", "n", 9},
      {"if (a) n = 3; else n = 8;", "n", 8},
      {"n = 2; if (a) n = 6;", "n", 6},
      {"if (a) return; else n = 5;", "n", 5},
      {"if (R[0] < 40)", "R[0]", 39},
      {"d = R[0]; if (d > 40) d = 40;", "d", 40},
      {"if (R[0] == 255) return;", "R[0]", 254},
      {"if (R[0] != 0) return;", "R[0]", 0},
      {"d = R[1]; if (d >= 200) d = 0;", "d", 199},
      {"u = P[0]; if (u > 20) return;", "u", 20},
      {"w = P_i[0]; if (w < 0 || w > 20) return;", "(int)w", 20},
      // switch.
      {"switch (n) { case 3: case 8: break; default: return; }", "n", 8},
      {"switch (n) { case 2: a = 1; break; case 5: a = 2; break; default: n = 1; }", "n", 5},
      {"switch (a) { case 2: n = 1; break; case 5: n = 7; break; default: n = 0; }", "n", 7},
      {"switch (a) { case 2: n = 1; /* fall */ case 5: n = 4; break; default: n = 0; }", "n", 4},
      {"n = 1; switch (a) { case 2: n = 3; }", "n", 3},
      // Loops.
      {"for (k = 0; k < 8; k++)", "k", 7},
      {"for (k = 0; k <= 8; k++)", "k", 8},
      {"for (k = 8; k > 0; k--)", "k", 8},
      {"for (k = 8; k >= 0; k--)", "k", 8},
      {"for (k = 0; k < 8; k += 3)", "k", 7},
      {"for (k = 0; k < 8; k++) a++;", "k", 8},
      {"k = 8; while (k > 3) k--;", "k", 3},
      {"k = 0; do k++; while (k < 5);", "k", 5},
      {"for (k = 0; k < 8; k++) { if (k == 5) break; }", "k", 8},
      {"for (k = 0; k < 8; k++) { if (k & 1) continue; a++; }", "k", 8},
      {"n = 4; for (k = 0; k < 8; k++) a++;", "n", 4},
      {"n = 4; for (k = 0; k < 8; k++) { if (a) n = 6; }", "n & 7", 7},
      {"for (k = 0; k < 8; k++) for (m = 0; m < 4; m++)", "k * 4 + m", 31},
      // goto.
      {"n = 2; if (a) goto on; n = 6; on:", "n", 6},
      {"if (n < 0 || n > 9) goto out; k = n; goto on; out: k = 4; on:", "k", 9},
      // A goto leads into an arm: what the condition says still holds in front of its label.
      {"n = 0; if (a) goto in; if (u < 10) { n = u; in: ; } else n = 3;", "n", 9},
      {"n = 0; if (a) goto in; if (u > 19) return; if (u < 10) n = 3; else { n = u - 10; in: ; }", "n", 9},
      {"if (a) goto in; if (u > 9) { in: return; }", "u", 9},
      // What is stored beside a cell leaves it as it is.
      {"if (R[0] > 39) return; for (k = 0; k < 3; k++) R[1] = k;", "R[0]", 39},
      {"if (R[0] > 39) return; for (k = 0; k < 3; k++) R[1] += 2;", "R[0]", 39},
      {"if (R[0] > 39) return; for (k = 0; k < 3; k++) R[1]++;", "R[0]", 39},
  };
  for (const Known& row : rows) {
    EXPECT_FALSE(IsChecked(row.before, row.index, row.most + 1)) << row.before << " table[" << row.index << "]";
    if (row.before.ends_with("n = 0;")) {
      EXPECT_TRUE(IsChecked(row.before, row.index, row.most)) << row.before;
    }
    // Of a known number it is an error of the program.
    const bool constant = row.index == "MOST" || row.before.ends_with("n = 0;") || row.before.starts_with("n = 3;") ||
                          row.before.starts_with("k = (n = 5)");
    if (row.most != 0 && !constant) {
      EXPECT_TRUE(IsChecked(row.before, row.index, row.most)) << row.before << " table[" << row.index << "]";
    }
  }
}

// covers: HNC-278
TEST(HncRanges, WhatMayHaveChangedIsChecked) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "n"},
      {"", "a"},
      {"", "R_c[0]"},
      {"", "any(n)"},
      {"n = 3; n = a;", "n"},
      {"n = 3; if (b) n = a;", "n"},
      {"n = 3; if (b) { } else n = a;", "n"},
      {"n = 3; while (b) { b--; n = a; }", "n"},
      {"n = 3; for (k = 0; k < 4; k++) { n = m; }", "n"},
      {"n = 3; for (k = 0; k < 4; k++, n = m) { }", "n"},
      {"for (k = 0; k < 4; k++) { if (n < 0 || n > 9) n = 0; n = m; }", "n"},
      {"n = 3; do { n = m; } while (0);", "n"},
      {"n = 3; switch (b) { case 1: n = m; }", "n"},
      {"n = 3; switch (b) { case 1: n = m; break; case 2: n = 5; }", "n"},
      {"n = 3; switch (b) { case 1: n = m; /* fall */ case 2: a = 1; }", "n"},
      {"n = 3; b ? (n = m) : 0;", "n"},
      {"n = 3; b && (n = m);", "n"},
      {"n = 3; b || (n = m);", "n"},
      {"n = 3; if (b) goto on; n = m; on:", "n"},
      {"n = 3; n += m;", "n"},
      {"n = 3; n -= 4;", "n & 7 | n"},
      {"g = 3; *p = m;", "g"},
      {"g = 3; p[0] = m;", "g"},
      {"g = 3; (*p)++;", "g"},
      {"g = 3; spoil();", "g"},
      {"g = 3; a = any((spoil(), 1));", "g"},
      {"if (g < 0 || g > 9) return; spoil();", "g"},
      {"if (R[5] > 7) return; R_ui[2] = m;", "R[5]"},
      {"if (R[5] > 7) return; R[n & 7] = m;", "R[5]"},
      {"if (R[5] > 7) return; R_ul[1] = l;", "R[5]"},
      {"both.word = 3; both.bytes[1] = m;", "both.word"},
      {"s.three = 3; s.four = m;", "s.four"},
      {"n = below_ten(a) - 3; q = table + 4; q += n; *(q - 2) = 2; n = 0;", "n"},
      {"n = below_ten(a); q = table + 4; q -= n; *q = 2; n = 0;", "n"},
      {"n = below_ten(a); q = table; q += n; q -= 1; *q = 2; n = 0;", "n"},
      {"q = table; q += m; *q = 2; n = 0;", "n"},
      // What is stored in memory may be forced to be another number.
      {"if (R[5] > 40) R[5] = 40;", "R[5]"},
      {"g = 3; a = g;", "g"},
      {"if (n <= 9) return;", "n"},
      {"if (n < 0 && n > 9) return;", "n"},
      {"if (n < 0 || m > 9) return;", "n"},
      {"if (n > 9) return;", "n"},
      {"if (n < 0) return;", "n"},
      {"if (n != 4) a = 1;", "n"},
      {"switch (n) { case 3: a = 1; break; case 8: a = 2; }", "n"},
      {"switch (n) { case 3: return; default: a = 1; }", "n"},
      {"if (n >= 0 && n < 10) a = 1;", "n"},
      {"if (n >= 0 && n < 10) goto on; a = 1; on:", "n"},
      // What a condition says does not outlive what it chooses.
      {"k = u > 9 ? 1 : 2;", "u"},
      {"k = u < 10 ? 1 : 2;", "u"},
      {"k = u > 9 ? a++ : b++;", "u"},
      {"k = u < 10 ? a++ : b++;", "u"},
      {"u < 10 ? a++ : b++;", "u"},
      {"u > 9 ? a++ : b++;", "u"},
      {"u < 10 && a++;", "u"},
      {"u > 9 || a++;", "u"},
      {"k = u < 10 && a;", "u"},
      {"k = u > 9 || a;", "u"},
      {"k = u < 10;", "u"},
      {"q = u < 10 ? &g : table; *q = 1;", "u"},
      {"q = u > 9 ? &g : table; *q = 1;", "u"},
      {"if (u > 9 ? a : b) a = 1;", "u"},
      {"while (u > 9 && k < 5) k++;", "u"},
      // Of a number that is 0 its complement is none, and the other way about.
      {"if (-n)", "n"},
      {"if (~n)", "n"},
      {"if (!-n) return;", "n"},
      {"if (!~n) a = 1;", "n"},
  };
  for (const auto& [before, index] : rows) {
    EXPECT_TRUE(IsChecked(before, index, before.find("R[5]") != std::string::npos ? 200 : 20))
        << before << " table[" << index << "]";
  }
}

}  // namespace
}  // namespace plcxx::hnc
