// Where values are in State: against the offsets of the symbol map, in a sample of each language.

#include "transpiler/link/cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/emit/legalize/legalize.h"

namespace plcxx::debug_link {
namespace {

using testing::ElementsAre;

struct Compiled {
  compilation::CompilationRequest request;
  compilation::Compilation compilation;
  emit::Emittable emittable;

  explicit Compiled(compilation::CompilationRequest asked) : request(std::move(asked)) {
    compilation = compilation::Compile(request);
    EXPECT_TRUE(compilation.ok()) << request.sources.front();
    if (compilation.ok()) emittable = emit::legalize::Legalize(compilation.program, {.name = "program"});
  }

  std::vector<Cell> Cells(const std::string& name) const {
    const auto location = compilation.dialect->locate(ir::NameIndex(compilation.program), name);
    EXPECT_TRUE(location) << name;
    return CellsOf(*emittable.program, emittable.layout, location->place);
  }
};

/// Every place that the symbol map has, by its offset there.
void AgreesWithTheMap(const Compiled& compiled) {
  const ir::Program& program = *compiled.emittable.program;
  uint32_t places = 0;
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const ir::Place& place = program.places[ir::PlaceId(i)];
    const emit::layout::PlaceStorage& stored = compiled.emittable.layout.places[i];
    if (place.indexed || stored.storage == emit::layout::Storage::kNone ||
        stored.storage == emit::layout::Storage::kLocal) {
      continue;
    }
    const std::vector<Cell> cells = CellsOf(program, compiled.emittable.layout, place);
    ASSERT_FALSE(cells.empty()) << place.name;
    uint32_t lowest = cells.front().offset, bits = 0;
    for (const Cell& cell : cells) {
      lowest = std::min(lowest, cell.offset);
      bits += cell.bits;
      EXPECT_LT(cell.offset, compiled.emittable.layout.size);
    }
    EXPECT_EQ(lowest, stored.offset) << place.name;
    EXPECT_EQ(bits, place.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(place.type)) << place.name;
    if (place.type == ir::Type::kBit) {
      EXPECT_EQ(cells.front().bit, stored.storage == emit::layout::Storage::kPackedBit ||
                                           stored.storage == emit::layout::Storage::kRetentiveBit
                                       ? stored.bit
                                       : 0)
          << place.name;
    }
    ++places;
  }
  EXPECT_GT(places, 2u);
}

compilation::CompilationRequest Golden(const std::string& dialect, const std::string& file) {
  compilation::CompilationRequest request;
  request.sources = {std::string(PLCXX_ROOT) + "/tests/golden/" + dialect + "/" + file};
  request.dialect = dialect;
  return request;
}

TEST(Cells, AreWhereTheMapSays) {
  AgreesWithTheMap(Compiled(Golden("nc110", "timers/different_members_of_a_chain.plc")));
  AgreesWithTheMap(Compiled(Golden("technol", "assembler/shifts_and_rotations_32.plc")));
  AgreesWithTheMap(Compiled(Golden("host50", "basic/long_rung.il")));
  AgreesWithTheMap(Compiled(Golden("prostep", "functional/fm_15_and_16.plc")));
  AgreesWithTheMap(Compiled(Golden("classicladder", "flow/calls.clp")));
}

/// A bool that holds anything but 0 and 1 is undefined for the machine's program: no value makes the tool write
/// another.
TEST(Cells, ATruthIsWrittenAsItsLowestBitAlone) {
  const Compiled compiled(Golden("nc110", "timers/different_members_of_a_chain.plc"));
  const ir::Program& program = *compiled.emittable.program;
  uint32_t truths = 0;
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const ir::Place& place = program.places[ir::PlaceId(i)];
    const emit::layout::Storage storage = compiled.emittable.layout.places[i].storage;
    if (place.type != ir::Type::kBit) continue;
    if (storage != emit::layout::Storage::kBit && storage != emit::layout::Storage::kField) continue;
    for (const MaskedRun& run : WritesOf(CellsOf(program, compiled.emittable.layout, place), ~uint64_t{0}, 32)) {
      EXPECT_THAT(run.masks, ElementsAre(1)) << place.name;
      EXPECT_THAT(run.values, ElementsAre(1)) << place.name;
      ++truths;
    }
  }
  EXPECT_GT(truths, 2u);
}

TEST(Cells, ABitAByteAndWhatIsNotThere) {
  compilation::CompilationRequest request;
  request.sources = {"a.plc"};
  request.texts = {{"a.plc", "$\nU4A8=I0A3\nU4A9=U4A8\nW3K0=[W3K0+1]\nU100K0=[W3K0=5]\n"}};
  const Compiled compiled(request);
  const std::vector<Cell> bit = compiled.Cells("U4A8");
  ASSERT_EQ(bit.size(), 1u);
  EXPECT_EQ(bit[0].bits, 1);
  EXPECT_EQ(compiled.Cells("W3K0").size(), 1u) << "a byte in nc110";
  EXPECT_TRUE(compiled.Cells("U4A20").empty()) << "the program does not use it";
}

TEST(Cells, RunsAreWholeAndDisjoint) {
  const std::vector<Cell> cells = {
      {.offset = 9}, {.offset = 3}, {.offset = 4}, {.offset = 3, .bit = 1, .bits = 1}, {.offset = 5}};
  EXPECT_THAT(RunsOf(cells, 8), ElementsAre(debug_link::Run{3, 3}, debug_link::Run{9, 1}));
  EXPECT_THAT(RunsOf(cells, 2), ElementsAre(debug_link::Run{3, 2}, debug_link::Run{5, 1}, debug_link::Run{9, 1}));
}

TEST(Cells, ValuesAreTakenApartAndPutTogether) {
  const std::vector<Cell> cells = {{.offset = 7, .bit = 0, .bits = 8, .at = 0},
                                   {.offset = 2, .bit = 3, .bits = 2, .at = 8},
                                   {.offset = 3, .bit = 0, .bits = 1, .at = 10}};
  KnownBytes bytes;
  for (const MaskedRun& run : WritesOf(cells, 0x5A7, 32)) {
    for (size_t i = 0; i < run.masks.size(); ++i) {
      bytes[run.offset + static_cast<uint32_t>(i)] = static_cast<uint8_t>(run.values[i] & run.masks[i]);
    }
  }
  EXPECT_EQ(ValueOf(cells, bytes), 0x5A7u);
  EXPECT_EQ(bytes[2], 0x08);
  EXPECT_THAT(WritesOf(cells, 0, 32), ElementsAre(MaskedRun{2, {0x18, 0x01}, {0, 0}}, MaskedRun{7, {0xFF}, {0}}));
}

}  // namespace
}  // namespace plcxx::debug_link
