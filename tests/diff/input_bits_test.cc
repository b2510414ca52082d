// What is set of a machine's input bit by bit arrives bit by bit: searches and proofs set inputs so, scenarios whole
// ones.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/ir/zones.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/runs.h"

namespace plcxx::review::diff {
namespace {

struct Smallest {
  std::string dialect, file, text;
};

void PrintTo(const Smallest& program, std::ostream* out) { *out << program.dialect; }

class InputBits : public testing::TestWithParam<Smallest> {};

TEST_P(InputBits, ArriveAlone) {
  const testing_support::TemporaryDirectory directory;
  compilation::CompilationRequest request;
  request.dialect = GetParam().dialect;
  request.sources = {directory.Write(GetParam().file, GetParam().text)};
  const DiffSide side = MakeDiffSide("program", request);
  ASSERT_TRUE(side.compilation.ok() && side.compilation.has_program);
  const prove::machine::Version version = prove::machine::MakeVersion(side.whole);
  const ir::Program& program = side.whole;
  uint32_t looked_at = 0;
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    const ir::SpaceId space(i);
    if (!program.spaces[space].host_visible) continue;
    for (const ir::Zone& zone : program.spaces[space].zones) {
      // Of a byte that the control shares only some bits are its own.
      if (zone.direction != ir::Direction::kInput || !ir::IsOfBytes(zone)) continue;
      const uint32_t end = zone.end / 8;
      // One byte is as the next one; the last one of a zone is not.
      for (uint32_t offset = zone.begin / 8; offset < end; offset += offset + 9 < end ? 8 : 1) {
        DiffMachine machine(side, version);
        const auto set = [&](uint8_t bit, uint64_t value) {
          const execute::CellId cell = version.cells.OfBit(space, offset, bit);
          machine.Apply({.inputs = {{.old_cell = cell, .new_cell = cell, .value = value}}, .words = {}, .slow = 1},
                        &prove::diff::SetCell::old_cell);
          machine.Look();
        };
        const auto value = [&] {
          uint64_t byte = 0;
          for (uint8_t bit = 0; bit < 8; ++bit) byte |= machine.ValueOf(version.cells.OfBit(space, offset, bit)) << bit;
          return byte;
        };
        const std::string where = program.spaces[space].name + " byte " + std::to_string(offset);
        if (program.spaces[space].name == "bits") {  // a bit of this language is a byte of 0 or 1
          set(0, 1);
          EXPECT_EQ(value(), 1U) << where;
          continue;
        }
        set(7, 1);
        if (value() == 0) continue;  // the control itself drives it
        EXPECT_EQ(value(), 0x80U) << where;
        set(2, 1);
        EXPECT_EQ(value(), 0x84U) << where;
        set(7, 0);
        EXPECT_EQ(value(), 0x04U) << where;
        ++looked_at;
      }
    }
  }
  EXPECT_GT(looked_at, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Languages, InputBits,
    testing::Values(Smallest{"nc110", "p.plc", "$\nU4A0=I0A0\n"},
                    Smallest{"host50", "p.il", "SLOWDIV 2\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n"},
                    Smallest{"classicladder", "p.clp",
                             "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n_/FILE-sections.csv\n"
                             "_FILE-rung_0.csv\n1-0-50/0 , 50-0-60/0\n_/FILE-rung_0.csv\n_/FILES_CLASSICLADDER\n"}));

}  // namespace
}  // namespace plcxx::review::diff
