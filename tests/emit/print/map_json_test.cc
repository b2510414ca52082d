// <name>.map.json: what a tool needs to read a symbol out of State, and where a statement comes from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kMapped = R"(program "p" test
space A 32 volatile little host_visible "outputs"
space Z 16 volatile big host_visible "of the other order"
space T 8 retentive little host_visible "kept"
space B 8 retentive big host_visible "kept, of the other order"
state T5 on_delay_timer
state C7 ring_counter
place single bit A[0].5
place packed bit A[2].3
place around i8 A[2]
place kept bit T[1].4
place kept_byte i8 T[2]
place wide i16 Z[0] address WZ0
place half i8 Z[0]
place other_half i8 Z[1]
place kept_wide i16 B[0]
place little i16 A[4]
place little_half i8 A[4]
place row i8 A[8] stride 2 low 8 high 28 indexed
place row_of_words i16 Z[7] stride 3 low 2 high 14 indexed
place T5U bit field T5 done
place C7W i8 field C7 count
routine fast fast {
  body {
    stmt s1f
    %0 = load single
    store packed %0
    store kept %0
    %1 = load around
    store kept_byte %1
    store half %1
    store other_half %1
    store little_half %1
    %2 = load little
    store wide %2
    store kept_wide %2
    %3 = const i32 2
    store row[%3] %1
    store row_of_words[%3] %2
    stmt s20
    %4 = load T5U
    store single %4
  }
}
)";

std::string MapOf(ir::Program& program, const source::SourceManager& sources) {
  return PrintMap(legalize::Legalize(program, {.name = "p"}), sources);
}

/// The line of a symbol, from its name to what comes after its offset.
std::string LineOf(const std::string& map, const std::string& name) {
  const size_t begin = map.find("{\"name\": \"" + name + "\"");
  return begin == std::string::npos ? "" : map.substr(begin, map.find('\n', begin) - begin);
}

uint32_t OffsetOf(const std::string& map, const std::string& name) {
  const std::string line = LineOf(map, name), key = "\"offset\": ";
  return static_cast<uint32_t>(std::stoul(line.substr(line.find(key) + key.size())));
}

TEST(MapJson, ASymbolHasWhatItTakesToReadIt) {
  ir::Program program = ir::ReadOrDie(kMapped);
  const source::SourceManager sources;
  const std::string map = MapOf(program, sources);
  const auto rest = [&](const std::string& name) {
    const std::string line = LineOf(map, name), offset = std::to_string(OffsetOf(map, name));
    const size_t at = line.find("\"offset\": " + offset);
    return line.substr(at + 10 + offset.size());
  };
  EXPECT_THAT(LineOf(map, "wide"),
              HasSubstr("\"source\": \"wide\", \"address\": \"WZ0\", \"type\": \"i16\", \"offset\""));
  EXPECT_THAT(LineOf(map, "single"), HasSubstr("\"address\": \"single\", \"type\": \"bit\", \"offset\""));
  // The bit, where several are kept in a byte.
  EXPECT_EQ(rest("single"), "},");
  EXPECT_EQ(rest("packed"), ", \"bit\": 3},");
  EXPECT_EQ(rest("kept"), ", \"bit\": 4},");
  EXPECT_EQ(OffsetOf(map, "packed"), OffsetOf(map, "around"));
  EXPECT_EQ(OffsetOf(map, "kept_byte"), OffsetOf(map, "kept") + 1);
  // The order, where it is not that of the machine's own words.
  EXPECT_EQ(rest("wide"), ", \"order\": \"big\"},");
  EXPECT_EQ(rest("kept_wide"), ", \"order\": \"big\"},");
  EXPECT_EQ(rest("little"), "},");
  EXPECT_EQ(rest("half"), "},");
  EXPECT_EQ(OffsetOf(map, "other_half"), OffsetOf(map, "half") + 1);
  EXPECT_EQ(OffsetOf(map, "wide"), OffsetOf(map, "half"));
  // Bytes 8, 10, .. 26 of A; words of Z at 4, 7 and 10, of which the one at 7 has the index 0.
  EXPECT_EQ(rest("row"), ", \"first\": 0, \"stride\": 2, \"lowest_index\": 0, \"count\": 10},");
  EXPECT_EQ(rest("row_of_words"),
            ", \"order\": \"big\", \"first\": 2, \"stride\": 3, \"lowest_index\": -1, \"count\": 3},");
}

TEST(MapJson, AnInstanceHasItsFields) {
  ir::Program program = ir::ReadOrDie(kMapped);
  const source::SourceManager sources;
  const std::string map = MapOf(program, sources), timer = LineOf(map, "T5");
  EXPECT_THAT(timer, HasSubstr("\"source\": \"T5\", \"kind\": \"on_delay_timer\", \"offset\": "));
  EXPECT_THAT(timer, HasSubstr("\"fields\": {\""));
  EXPECT_THAT(timer, HasSubstr("\"done\": " + std::to_string(OffsetOf(map, "T5U"))));
  EXPECT_THAT(timer, EndsWith("}},"));
  EXPECT_THAT(timer, Not(HasSubstr("{, ")));
  EXPECT_THAT(LineOf(map, "C7"), HasSubstr("\"count\": " + std::to_string(OffsetOf(map, "C7W"))));
  EXPECT_THAT(LineOf(map, "C7"), EndsWith("}}"));
}

TEST(MapJson, ACommentIsTheHelpOrElseTheMeaning) {
  ir::Program program = ir::ReadOrDie(kMapped);
  ir::Documentation known;
  known.address = "single";
  known.meaning = "door \"A\" is\topen";
  program.documentation.push_back(known);
  known.address = "packed";
  known.help = "the lamp";
  known.predefined = "LAMP";
  program.documentation.push_back(known);
  known.address = "kept";
  known.meaning = known.help = "";
  program.documentation.push_back(known);
  const source::SourceManager sources;
  const std::string map = MapOf(program, sources);
  EXPECT_THAT(LineOf(map, "single"), EndsWith(", \"comment\": \"door \\\"A\\\" is\\u0009open\"},"));
  EXPECT_THAT(LineOf(map, "packed"), EndsWith(", \"predefined\": \"LAMP\", \"comment\": \"the lamp\"},"));
  EXPECT_THAT(LineOf(map, "kept"), EndsWith(", \"bit\": 4, \"predefined\": \"LAMP\"},"));
}

// Each once, with the file's name alone.
TEST(MapJson, AStatementHasItsPlaceInTheSource) {
  ir::Program program = ir::ReadOrDie(kMapped);
  source::SourceManager sources;
  const source::FileId file = sources.AddText("somewhere/deep/door.plc", "first\n  second\n");
  const source::Offset begin = sources.Get(file).base;
  program.statements[ir::StatementId(0)].range = {begin, begin + 5};
  program.statements[ir::StatementId(0)].subject = "single";
  program.statements[ir::StatementId(1)].range = {begin + 8, begin + 14};
  const std::string map = MapOf(program, sources);
  EXPECT_THAT(map,
              HasSubstr("\"statements\": [\n    {\"id\": 31, \"subject\": \"single\", \"file\": \"door.plc\", "
                        "\"line\": 1, \"column\": 1},\n    {\"id\": 32, \"subject\": \"\", \"file\": \"door.plc\", "
                        "\"line\": 2, \"column\": 3}\n  ]\n}\n"));
  EXPECT_THAT(map, testing::StartsWith("{\n  \"program\": \"p\",\n  \"dialect\": \"test\",\n  \"state_bytes\": "));
  program.statements[ir::StatementId(1)].id = 31;
  EXPECT_THAT(MapOf(program, sources), Not(HasSubstr("\"line\": 2")));
  program.statements[ir::StatementId(0)].range = {};
  program.statements[ir::StatementId(1)].range = {};
  EXPECT_THAT(MapOf(program, sources), EndsWith("\"statements\": [\n  ]\n}\n"));
}

}  // namespace
}  // namespace plcxx::emit::print
