// Bits that the control takes back are found wherever the program asks for them.
#include "transpiler/prove/machine/requests.h"

#include <gtest/gtest.h>

#include <string>

#include "transpiler/ir/reader.h"

namespace plcxx::prove {
namespace {

/// "if the request stands, ask the host; if it has done it, the request is over".
std::string Asking(const std::string& around_the_end = "{0}") {
  const std::string end = "if %4 {\n%5 = const bit 0\nstore request %5\n}\n";
  std::string ends = around_the_end;
  ends.replace(ends.find("{0}"), 3, end);
  return "%0 = load request\nif %0 {\n%2 = host ask ()\n%3 = const i8 1\n%4 = eq.i8 %2 %3\n" + ends + "}\n";
}

/// Whether the bit is a request of a program whose period is this.
bool IsRequest(const std::string& period) {
  const ir::Program program = ir::ReadOrDie(
      "program p test\n"
      "space M 2 volatile little host_visible\n"
      "place request bit M[0].0\n"
      "place other i8 M[1]\n"
      "host ask () -> i8 polled\n"
      "routine period schedule {\n" +
      period + "}\nschedule period period\n");
  const machine::Version version = machine::MakeVersion(program);
  return machine::RequestCells(version)[version.cells.OfBit(ir::SpaceId(0), 0, 0).index];
}

TEST(Requests, InALine) { EXPECT_TRUE(IsRequest(Asking())); }

TEST(Requests, InBlocksChoicesAndLoops) {
  EXPECT_TRUE(IsRequest("block @1 {\n" + Asking() + "}\n"));
  EXPECT_TRUE(IsRequest(Asking("block @1 {\n{0}}\n")));
  EXPECT_TRUE(IsRequest("%9 = load other\nswitch %9 {\ncase 1 {\n" + Asking() + "}\n}\n"));
  EXPECT_TRUE(IsRequest("loop @1 guard 3 {\nbody {\n" + Asking() + "}\n}\n"));
}

TEST(Requests, OnlyWhereTheHostWasAsked) {
  EXPECT_FALSE(IsRequest("%0 = load request\nif %0 {\n%1 = const bit 0\nstore request %1\n}\n"));
  // Asked in one case, cleared in another one.
  EXPECT_FALSE(
      IsRequest("%0 = load request\nif %0 {\n%9 = load other\nswitch %9 {\ncase 1 {\n%2 = host ask ()\n}\ncase 2 {\n"
                "%5 = const bit 0\nstore request %5\n}\n}\n}\n"));
}

}  // namespace
}  // namespace plcxx::prove
