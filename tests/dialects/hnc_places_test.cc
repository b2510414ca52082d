// What the cells of a program are called: in the generated code, and in scenarios and reports (specification 4.4).
#include <string>
#include <utility>
#include <vector>

#include "hnc_lowered.h"

namespace plcxx::hnc {
namespace {

using testing::Contains;
using testing::Not;

/// "R5 R[5]" of each place of a program whose plc1() has these statements: its name and how a scenario names it.
std::vector<std::string> Places(const std::string& statements) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nstruct axis { int speed; unsigned char on; struct { int x; int y[2]; } in; };\n"
            "struct axis axes[3], one; union { long l; unsigned char c[4]; } both; int a, grid[3][2], table[8];\n"
            "struct { int : 4; unsigned low : 4; int next; } bits; long l;\nvoid plc1() { static int hist[4]; " +
                statements + " }\nvoid init() { plc1_time = 16; plc2_time = 32; }\nvoid plc2() { }\n");
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << statements << testing::PrintToString(lowered.Reported());
  std::vector<std::string> found;
  for (const ir::Place& place : lowered.program().places) found.push_back(place.name + " " + place.address);
  return found;
}

// covers: HNC-126, HNC-127
TEST(HncPlaces, CellsAreNamedByTheirAreaAndTheirNumber) {
  for (const auto& [statement, place] : std::vector<std::pair<std::string, std::string>>{
           {"R[5] = 1;", "R5 R[5]"},
           {"R_uc[5] = 1;", "R5 R[5]"},
           {"R_ui[15] = 1;", "R_ui_15 R_ui[15]"},
           {"R_i[15] = 1;", "R_ui_15 R_ui[15]"},
           {"R_ul[3] = 1;", "R_ul_3 R_ul[3]"},
           {"*(unsigned *)&R[301] = 1;", "R_ui_at_301 R_ui_at_301"},
           {"*(unsigned long *)&R[6] = 1;", "R_ul_at_6 R_ul_at_6"},
           {"Y[127] = 1;", "Y127 Y[127]"},
           {"Y_ui[2] = 1;", "Y_ui_2 Y_ui[2]"},
           {"a = X[3];", "X3 X[3]"},
           {"l = X_l[3];", "X_ul_3 X_ul[3]"},
           {"a = P[7];", "P7 P[7]"},
           {"B[99] = 1;", "B99 B[99]"},
           {"B_uc[3] = 1;", "B_uc_3 B_uc[3]"},
           {"B_ul[2] = 1;", "B_ul_2 B_ul[2]"},
           {"*G[162] = 1;", "G162 G[162]"},
           {"*G_i[162] = 1;", "G162 G[162]"},
           {"a = *F[40];", "F40 F[40]"},
           {"l = *F_l[1];", "F_ul_at_2 F_ul[1]"},
           {"table[3] = 1;", "table_3 table[3]"},
           {"a = 1;", "a a"},
           {"hist[2] = 1;", "plc1_hist_2 plc1.hist[2]"},
           {"grid[2][1] = 1;", "grid_2_1 grid[2][1]"},
           {"one.speed = 1;", "one_speed one.speed"},
           {"one.on = 1;", "one_on one.on"},
           {"axes[1].speed = 1;", "axes_1_speed axes[1].speed"},
           {"axes[2].in.x = 1;", "axes_2_in_x axes[2].in.x"},
           {"axes[2].in.y[1] = 1;", "axes_2_in_y_1 axes[2].in.y[1]"},
           {"both.l = 1;", "both_l both.l"},
           {"bits.next = 1;", "bits_next bits.next"},
           {"((unsigned char *)&a)[1] = 1;", "a_byte_1 a_byte_1"},
           {"((unsigned char *)&table[2])[1] = 1;", "table_2_byte_1 table_2_byte_1"},
           {"((unsigned char *)&axes[1].in.x)[1] = 1;", "axes_1_in_x_byte_1 axes_1_in_x_byte_1"},
       }) {
    EXPECT_THAT(Places(statement), Contains(place)) << statement;
  }
}

// covers: HNC-139
TEST(HncPlaces, WhatIsIndexedIsNamedByItsObjectAndWhereItBegins) {
  for (const auto& [statement, place] : std::vector<std::pair<std::string, std::string>>{
           {"R[a] = 1;", "R "},
           {"R_ui[a] = 1;", "R_ui "},
           {"R_ul[a] = 1;", "R_ul "},
           {"Y[a] = 1;", "Y "},
           {"B[a] = 1;", "B "},
           {"B_uc[a] = 1;", "B_uc "},
           {"*G[a] = 1;", "G "},
           {"l = *F_l[a];", "F_ul_by_2 "},
           {"(R + 5)[a] = 1;", "R_from_5 "},
           {"(R_ui + 5)[a] = 1;", "R_ui_from_5 "},
           {"((struct axis *)R)[a].speed = 1;", "R_ui_by_9 "},
           {"((struct axis *)R)[a].on = 1;", "R_from_0_by_9 "},
           {"table[a] = 1;", "table "},
           {"(table + 3)[a] = 1;", "table_from_6 "},
           {"hist[a & 3] = 1;", "plc1_hist "},
           {"axes[a].speed = 1;", "axes_speed "},
           {"axes[a].on = 1;", "axes_on "},
           {"axes[a].in.y[1] = 1;", "axes_in_y_1 "},
           {"axes[1].in.y[a] = 1;", "axes_from_14_by_2 "},
           {"grid[1][a] = 1;", "grid_from_4_by_2 "},
           {"grid[a][1] = 1;", "grid_from_2 "},
           {"both.c[a] = 1;", "both_from_0_by_1 "},
       }) {
    EXPECT_THAT(Places(statement), Contains(place)) << statement;
  }
}

// Of two places of one name the second one is not the first one.
TEST(HncPlaces, EachWidthHasAPlaceOfItsOwn) {
  const std::vector<std::string> places = Places("R[4] = 1; R_ui[2] = 2; R_ul[1] = 3; R[4] = 4; R_ui[2] = 5;");
  for (const char* place : {"R4 R[4]", "R_ui_2 R_ui[2]", "R_ul_1 R_ul[1]"}) {
    EXPECT_EQ(std::ranges::count(places, place), 1) << place;
  }
  EXPECT_THAT(places, Not(Contains("R5 R[5]")));
}

}  // namespace
}  // namespace plcxx::hnc
