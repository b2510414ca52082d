// Terms in many lanes at once have the values that one evaluation after the other gives.
#include "transpiler/symbolic/terms/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/random.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {
namespace {

/// Numbers near the ends of the range are where arithmetic differs.
uint64_t AnyValue(Random& random, uint8_t width) {
  const uint64_t next = random.Next();
  switch (next >> 40 & 3) {
    case 0:
      return Masked(next & 3, width);
    case 1:
      return Masked(0 - (next & 3), width);
    case 2:
      return Masked((uint64_t{1} << (width - 1)) + (next & 3) - 1, width);
    default:
      return Masked(next ^ next >> 17, width);
  }
}

struct Bench {
  Terms terms;
  std::vector<TermId> variables;
  std::vector<LaneProgram::VariableAt> places;
  uint32_t planes = 0;

  TermId Add(uint8_t width) {
    const TermId variable = terms.Variable("v" + std::to_string(variables.size()), width);
    variables.push_back(variable);
    places.push_back({variable, planes});
    planes += width;
    return variable;
  }

  /// Compares every root in every lane.
  void ExpectSame(std::span<const TermId> roots, Random& random) {
    std::vector<Plane> values(planes);
    std::vector<std::vector<uint64_t>> of_lane(Plane::kLanes, std::vector<uint64_t>(variables.size()));
    for (size_t v = 0; v < variables.size(); ++v) {
      const uint8_t width = terms.Width(variables[v]);
      for (uint32_t lane = 0; lane < Plane::kLanes; ++lane) {
        of_lane[lane][v] = AnyValue(random, width);
        SetInLane({&values[places[v].plane], width}, lane, of_lane[lane][v]);
      }
    }
    LaneProgram program(terms, places, roots);
    program.Run(values);
    for (uint32_t lane = 0; lane < Plane::kLanes; ++lane) {
      const std::vector<uint64_t> all = EvaluateAll(terms, of_lane[lane], TermId(terms.size() - 1));
      for (size_t root = 0; root < roots.size(); ++root)
        ASSERT_EQ(ValueInLane(program.Root(root), lane), all[roots[root].index]) << "root " << root << " lane " << lane;
    }
  }
};

uint64_t Sum(std::span<const uint64_t> arguments) {
  uint64_t sum = 7;
  for (const uint64_t argument : arguments) sum += argument;
  return sum;
}

TEST(Lanes, EachOperationInEachWidth) {
  Random random(0x1234567);
  for (const uint8_t width : std::array<uint8_t, 13>{1, 2, 3, 7, 8, 13, 16, 24, 31, 32, 33, 63, 64}) {
    Bench bench;
    Terms& t = bench.terms;
    const TermId a = bench.Add(width), b = bench.Add(width), c = bench.Add(1);
    std::vector<TermId> roots{
        t.Not(a),     t.And(a, b),  t.Or(a, b),   t.Xor(a, b),    t.Add(a, b), t.Sub(a, b),      t.Mul(a, b),
        t.Udiv(a, b), t.Urem(a, b), t.Sdiv(a, b), t.Srem(a, b),   t.Shl(a, b), t.Lshr(a, b),     t.Ashr(a, b),
        t.Eq(a, b),   t.Ult(a, b),  t.Slt(a, b),  t.Ite(c, a, b), a,           t.Const(5, width)};
    if (width < 64) roots.push_back(t.Concat(c, a));
    if (width < 64) roots.push_back(t.Concat(a, c));
    if (width > 2) roots.push_back(t.Extract(a, 1, static_cast<uint8_t>(width - 2)));
    const std::array arguments{a, c};
    roots.push_back(t.Apply(t.Function("sum", width, Sum), arguments));
    roots.push_back(t.Apply(t.Function("unknown", width), arguments));
    bench.ExpectSame(roots, random);
  }
}

/// Shifts by what is hardly ever more than the width.
TEST(Lanes, ShiftsByALittle) {
  Random random(0x7654321);
  for (const uint8_t width : std::array<uint8_t, 5>{5, 8, 24, 32, 64}) {
    Bench bench;
    Terms& t = bench.terms;
    const TermId a = bench.Add(width), by = t.Zext(bench.Add(3), width),
                 far = t.Add(by, t.Const(uint64_t{width} - 4, width));
    bench.ExpectSame(
        std::array{t.Shl(a, by), t.Lshr(a, by), t.Ashr(a, by), t.Shl(a, far), t.Lshr(a, far), t.Ashr(a, far)}, random);
  }
}

/// Terms of terms, so that planes are used again, and are parts of others.
TEST(Lanes, RandomTerms) {
  Random random(0xABCDEF);
  for (int round = 0; round < 40; ++round) {
    Bench bench;
    Terms& t = bench.terms;
    std::vector<TermId> all;
    for (int i = 0; i < 12; ++i) all.push_back(bench.Add(static_cast<uint8_t>(i < 8 ? 1 : 1 + random.Next() % 64)));
    // Eight bits that lie beside each other are a byte without a copy.
    TermId byte = all[0];
    for (size_t i = 1; i < 8; ++i) byte = t.Concat(all[i], byte);
    all.push_back(byte);
    const auto any = [&] { return all[random.Next() % all.size()]; };
    const auto any_of = [&](uint8_t width) { return t.Resize(any(), width); };
    for (int i = 0; i < 150; ++i) {
      const TermId a = any();
      const uint8_t width = t.Width(a);
      const TermId b = any_of(width);
      switch (random.Next() % 18) {
        case 0:
          all.push_back(t.Not(a));
          break;
        case 1:
          all.push_back(t.And(a, b));
          break;
        case 2:
          all.push_back(t.Or(a, b));
          break;
        case 3:
          all.push_back(t.Xor(a, b));
          break;
        case 4:
          all.push_back(t.Add(a, b));
          break;
        case 5:
          all.push_back(t.Sub(a, b));
          break;
        case 6:
          all.push_back(t.Mul(a, t.Const(random.Next() % 10, width)));
          break;
        case 7:
          all.push_back(t.Udiv(a, b));
          break;
        case 8:
          all.push_back(t.Srem(a, b));
          break;
        case 9:
          all.push_back(t.Shl(a, b));
          break;
        case 10:
          all.push_back(t.Ashr(a, b));
          break;
        case 11:
          all.push_back(t.Eq(a, b));
          break;
        case 12:
          all.push_back(t.Ult(a, t.Const(AnyValue(random, width), width)));
          break;
        case 13:
          all.push_back(t.Slt(a, b));
          break;
        case 14:
          all.push_back(t.Ite(any_of(1), a, b));
          break;
        case 15:
          all.push_back(t.Extract(a, static_cast<uint8_t>(random.Next() % width), 1));
          break;
        case 16:
          if (width < 60) all.push_back(t.Concat(a, any_of(3)));
          break;
        default:
          all.push_back(t.Sext(any_of(4), 9));
          break;
      }
    }
    std::vector<TermId> roots;
    for (int i = 0; i < 30; ++i) roots.push_back(any());
    bench.ExpectSame(roots, random);
  }
}

}  // namespace
}  // namespace plcxx::terms
