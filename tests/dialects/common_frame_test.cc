// What the dialects share beside registers and logic: tables of signals, regions, host calls, texts of statements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/host_calls.h"
#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/common/signal_rows.h"
#include "transpiler/dialects/common/statement_texts.h"

namespace plcxx::dialects {
namespace {

using testing::ElementsAre;

TEST(CommonSignalRows, FieldsWithAndWithoutQuotes) {
  std::string_view line = R"(I0.1,"a, ""b""",,8,last)";
  std::vector<std::string> fields;
  for (int i = 0; i < 6; ++i) fields.push_back(TakeField(line));
  EXPECT_THAT(fields, ElementsAre("I0.1", "a, \"b\"", "", "8", "last", ""));
  std::string_view open = "\"no end";
  EXPECT_EQ(TakeField(open), "no end");
  EXPECT_EQ(open, "");
}

TEST(CommonSignalRows, TheHeadingAndEmptyLinesAreLeftOut) {
  std::vector<std::string> rows;
  ForEachSignalRow("address,name\na,1\n\nb,2", [&](std::string_view row) { rows.emplace_back(row); });
  EXPECT_THAT(rows, ElementsAre("a,1", "b,2"));
}

/// The operations of a region, in order.
std::vector<ir::OpKind> OpsOf(const ir::Program& program, ir::RegionId region) {
  std::vector<ir::OpKind> ops;
  for (const ir::InstId id : program.regions[region].insts) ops.push_back(program[id].op);
  return ops;
}

TEST(CommonBuilder, GoesBackToItsRegion) {
  ir::Program program;
  Builder builder(program);
  const ir::RoutineId routine = builder.AddRoutine("init", ir::RoutineKind::kInit, "Nothing.");
  const ir::RegionId body = program.routines[routine].body;
  builder.SetRegion(body);
  const ir::ValueId one = builder.Bit(1);
  ir::RegionId inner, deeper, otherwise;
  builder.Choose(
      one,
      [&] {
        inner = builder.region();
        builder.Bit(0);
        builder.When(one, [&] { deeper = builder.region(); });
      },
      [&] { otherwise = builder.region(); });
  EXPECT_EQ(builder.region(), body);
  ir::Switch arms;
  builder.AddArm(arms, {3}, [&] { builder.Bit(1); });
  builder.AddArm(arms, {}, [] {});
  EXPECT_EQ(builder.region(), body);
  EXPECT_THAT(arms.cases.at(0).values, ElementsAre(3u));
  EXPECT_THAT(OpsOf(program, arms.cases.at(0).region), ElementsAre(ir::OpKind::kConst));
  EXPECT_TRUE(arms.cases.at(1).values.empty());
  EXPECT_THAT(OpsOf(program, body), ElementsAre(ir::OpKind::kConst, ir::OpKind::kIf));
  EXPECT_THAT(OpsOf(program, inner), ElementsAre(ir::OpKind::kConst, ir::OpKind::kIf));
  EXPECT_TRUE(OpsOf(program, deeper).empty());
  EXPECT_TRUE(OpsOf(program, otherwise).empty());
}

enum class Call : uint8_t { kNow, kFault, kCount };

TEST(CommonHostCalls, AreFoundByTheirEnumerators) {
  ir::Program program;
  Builder builder(program);
  builder.SetRegion(builder.NewRegion());
  HostCalls<Call> host(builder);
  host.Add({{.call = Call::kFault,
             .name = "fault",
             .comment = "A fault.",
             .parameters = {{.name = "code", .type = ir::Type::kI8, .enumerators = {}}}},
            {.call = Call::kNow, .name = "now_ms", .routine_exchange = true, .comment = "", .result = ir::Type::kI32}});
  EXPECT_EQ(program.host_functions[host[Call::kNow]].name, "now_ms");
  const ir::ValueId now = builder.AsExchange(host(Call::kNow));
  EXPECT_EQ(program[now].type, ir::Type::kI32);
  const ir::Call& call = program.calls[ir::CallId(program[now].payload)];
  EXPECT_EQ(call.host, host[Call::kNow]);
  EXPECT_TRUE(call.exchange);
  EXPECT_FALSE(
      program.calls[ir::CallId(program[host(Call::kFault, {builder.Constant(ir::Type::kI8, 1)})].payload)].exchange);
}

enum class Where : uint8_t { kAbove, kBehind };
struct Remark {
  Where place;
  source::Range range;
};

TEST(CommonStatementTexts, WholeLinesAndTheCommentsAboveThem) {
  source::SourceManager sources;
  const source::FileId file = sources.AddText("a.plc", "; above\n  ONE ; behind\n  TWO  \n");
  const source::Offset base = sources.Get(file).base;
  const source::Range lines = LinesOf(sources, base + 10, base + 27);
  EXPECT_EQ(sources.Text(lines), "  ONE ; behind\n  TWO");
  EXPECT_EQ(PlaceText(sources, base + 10), "2:3");
  const std::vector<Remark> remarks = {{Where::kAbove, {base, base + 7}}, {Where::kBehind, {base + 14, base + 22}}};
  std::vector<source::Range> found;
  AddComments(remarks, 0, 2, Where::kAbove, found);
  EXPECT_THAT(found, ElementsAre(remarks[0].range));
  AddComments(remarks, 1, 1, Where::kBehind, found);
  RemoveCommentsIn(lines, found);
  EXPECT_THAT(found, ElementsAre(remarks[0].range));
}

}  // namespace
}  // namespace plcxx::dialects
