// Control flow as masks, and calls.

#include "transpiler/fleet/code_writer.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {

void RoutineWriter::WriteGuarded(const std::string& lanes, ir::RegionId region) {
  if (!region.valid() || program_.regions[region].insts.empty()) return;
  const std::string mask = NewName("a");
  out_ += "{ Plane " + mask + " = " + lanes + ";\nif (Any(" + mask + ")) {\n";
  contexts_.push_back({mask, ir::InstId(), false});
  WriteRegion(region);
  contexts_.pop_back();
  out_ += "} }\n";
}

void RoutineWriter::WriteIf(const ir::Inst& inst) {
  if (same_.Value(ir::ValueId(inst.a))) {
    out_ += "if (" + Scalar(ir::ValueId(inst.a)) + ") {\n";
    WriteRegion(ir::RegionId(inst.b));
    out_ += "} else {\n";
    WriteRegion(ir::RegionId(inst.c));
    out_ += "}\n";
    return;
  }
  const std::string condition = ValueName(ir::ValueId(inst.a));
  const std::string otherwise = NewName("e");
  // Before the first region, which may take lanes out of the mask.
  out_ += "{ const Plane " + otherwise + " = Without(" + Mask() + ", " + condition + ");\n";
  WriteGuarded("Within(" + Mask() + ", " + condition + ")", ir::RegionId(inst.b));
  WriteGuarded(otherwise, ir::RegionId(inst.c));
  out_ += "}\n";
}

/// As in C: a case that falls through has no break.
void RoutineWriter::WriteScalarSwitch(const ir::Inst& inst) {
  out_ += "switch (" + Scalar(ir::ValueId(inst.a)) + ") {\n";
  const bool is_bit = program_[ir::ValueId(inst.a)].type == ir::Type::kBit;
  for (const ir::SwitchCase& one : program_.switches[ir::SwitchId(inst.payload)].cases) {
    for (const uint64_t number : one.values)
      out_ += is_bit ? (number != 0 ? "case true:\n" : "case false:\n") : "case " + std::to_string(number) + "ull:\n";
    if (one.values.empty()) out_ += "default:\n";
    out_ += "{\n";
    WriteRegion(one.region);
    out_ += one.falls_through ? "}\n" : "}\nbreak;\n";
  }
  out_ += "}\n";
}

void RoutineWriter::WriteSwitch(const ir::Inst& inst) {
  if (same_.Value(ir::ValueId(inst.a))) return WriteScalarSwitch(inst);
  const std::vector<ir::SwitchCase>& cases = program_.switches[ir::SwitchId(inst.payload)].cases;
  const ir::Inst& selector = program_[ir::ValueId(inst.a)];
  const std::string value = ValueName(ir::ValueId(inst.a)), rest = NewName("r");
  const std::string type(ir::CppName(selector.type));
  out_ += "{ Plane " + rest + " = ToPlane(" + Mask() + ");\n";
  std::vector<std::string> chosen;
  for (const ir::SwitchCase& one : cases) {
    chosen.push_back(NewName("c"));
    out_ += "Plane " + chosen.back() + " = Zeros();\n";
    for (const uint64_t number : one.values) {
      if (selector.type == ir::Type::kBit) {
        out_ += chosen.back() + " |= " + (number != 0 ? "" : "~") + value + ";\n";
      } else {
        out_ += chosen.back() + " |= Equal<" + WidthText(selector.type) + ">(" + value + ", Fixed<" + type + ", " +
                std::to_string(number) + "ull>{});\n";
      }
    }
    out_ += chosen.back() + " &= " + rest + "; " + rest + " &= ~" + chosen.back() + ";\n";
  }
  // As in C, the default is taken when no other case is, wherever it stands.
  for (size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].values.empty()) out_ += chosen[i] + " = " + rest + ";\n";
  }
  for (size_t i = 0; i < cases.size(); ++i) {
    out_ += "if (Any(" + chosen[i] + ")) {\n";
    contexts_.push_back({chosen[i], ir::InstId(), false});
    WriteRegion(cases[i].region);
    contexts_.pop_back();
    out_ += "}\n";
    if (cases[i].falls_through && i + 1 < cases.size()) out_ += chosen[i + 1] + " |= " + chosen[i] + ";\n";
  }
  out_ += "}\n";
}

void RoutineWriter::WriteBlock(ir::InstId id, const ir::Inst& inst) {
  const std::string mask = NewName("a");
  out_ += "{ Plane " + mask + " = ToPlane(" + Mask() + ");\n";
  contexts_.push_back({mask, id, false});
  WriteRegion(ir::RegionId(inst.a));
  contexts_.pop_back();
  out_ += "}\n";
}

void RoutineWriter::WriteLoop(ir::InstId id, const ir::Inst& inst) {
  const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
  const std::string inside = NewName("a"), body = NewName("a"), repeats = NewName("g"), round = NewName("n");
  out_ += "{ Plane " + inside + " = ToPlane(" + Mask() + ");\nfor (uint64_t " + round + " = 0; Any(" + inside +
          "); ++" + round + ") {\n";
  contexts_.push_back({inside, id, false});
  if (loop.condition.valid()) {
    WriteRegion(loop.condition);
    const ir::ValueId condition(program_.regions[loop.condition].insts.back());
    out_ += inside + " &= ToPlane(" + ValueName(condition) + ");\nif (!Any(" + inside + ")) break;\n";
  }
  switch (loop.kind) {
    case ir::LoopBound::kProven:
      out_ += "if (" + round + " >= " + std::to_string(loop.bound) + "ull) break;\n";
      break;
    case ir::LoopBound::kGuard:
      out_ += "if (" + round + " >= " + std::to_string(loop.bound) + "ull) {\n";
      WriteRegion(loop.exhausted);
      out_ += "break;\n}\n";
      break;
    case ir::LoopBound::kBudget:
      out_ += "Plane " + repeats + " = Zeros();\n";
      repeats_of_[id.index] = repeats;
      break;
  }
  out_ += "{ Plane " + body + " = " + inside + ";\n";
  contexts_.push_back({body, id, true});
  WriteRegion(loop.body);
  contexts_.pop_back();
  out_ += "}\n";
  if (loop.kind == ir::LoopBound::kBudget) {
    // Whoever has come to the end of the body has left the loop.
    out_ += inside + " &= " + repeats + ";\n";
    repeats_of_.erase(id.index);
  } else {
    WriteRegion(loop.step);
  }
  contexts_.pop_back();
  out_ += "} }\n";
}

void RoutineWriter::Leave(const std::string& lanes, ir::InstId target, bool repeats) {
  for (size_t i = contexts_.size(); i-- > 1;) {
    out_ += contexts_[i].mask + " &= ~" + lanes + ";\n";
    if (contexts_[i].owner != target) continue;
    // The body of a loop is inside the loop's own mask, which the lanes leave, too, unless they come again.
    if (!contexts_[i].is_body || repeats) return;
  }
}

void RoutineWriter::WriteExit(const ir::Inst& inst) {
  const std::string lanes = NewName("x");
  out_ += "const Plane " + lanes + " = " +
          (ir::ValueId(inst.a).valid() ? "Within(" + Mask() + ", " + ValueName(ir::ValueId(inst.a)) + ")"
                                       : "ToPlane(" + Mask() + ")") +
          ";\n";
  Leave(lanes, ir::InstId(inst.payload), false);
}

void RoutineWriter::WriteRepeat(const ir::Inst& inst) {
  const ir::InstId target(inst.payload);
  const ir::PlaceId budget = program_.loops[ir::LoopId(program_[target].payload)].budget;
  const std::string lanes = NewName("x"), left = NewName("l"), go = NewName("x");
  out_ += "{ const Plane " + lanes + " = " +
          (ir::ValueId(inst.a).valid() ? "Within(" + Mask() + ", " + ValueName(ir::ValueId(inst.a)) + ")"
                                       : "ToPlane(" + Mask() + ")") +
          ";\n";
  out_ += "const auto " + left + " = Held<32>(" + places_.Load(budget) + ");\n";
  out_ += "const Plane " + go + " = " + lanes + " & ~IsZero<32>(" + left + ");\n";
  out_ += places_.Store(budget, ir::ValueId(), "Sub<32>(" + left + ", Fixed<uint32_t, 1>{})", go) + "\n";
  out_ += repeats_of_.at(target.index) + " |= " + go + ";\n";
  Leave(go, target, true);
  WriteGuarded(lanes + " & ~" + go, ir::RegionId(inst.b));
  out_ += "}\n";
}

std::vector<std::pair<uint32_t, uint32_t>> RoutineWriter::PlanesOf(const std::set<LocalByte>& bytes) const {
  std::vector<std::pair<uint32_t, uint32_t>> ranges;  // first, count
  for (const auto& [space, offset] : bytes) {
    for (const uint32_t plane : layout_.At(space, offset).planes) {
      if (plane == kNowhere) continue;
      if (!ranges.empty() && ranges.back().first + ranges.back().second == plane) {
        ++ranges.back().second;
      } else {
        ranges.emplace_back(plane, 1);
      }
    }
  }
  return ranges;
}

std::vector<uint32_t> RoutineWriter::ScalarsOf(const std::set<LocalByte>& bytes) const {
  std::vector<uint32_t> scalars;
  for (const auto& [space, offset] : bytes) {
    if (const ByteHome& home = layout_.At(space, offset); home.is_scalar()) scalars.push_back(home.scalar);
  }
  return scalars;
}

std::string RoutineWriter::ClearLocals(ir::RoutineId callee, const std::string& mask) const {
  std::string out;
  for (const auto& [first, count] : PlanesOf(locals_.UsedFrom(callee)))
    out += "ClearPlanes(m, " + std::to_string(first) + ", " + std::to_string(count) + ", " + mask + ");\n";
  for (const uint32_t at : ScalarsOf(locals_.UsedFrom(callee))) out += "m.scalars[" + std::to_string(at) + "] = 0;\n";
  return out;
}

void RoutineWriter::WriteCall(ir::InstId id, const ir::Inst& inst) {
  const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
  const ir::Routine& routine = program_.routines[call.routine];
  const bool is_partition = routine.kind != ir::RoutineKind::kSubroutine;
  const ir::PlaceId result = routine.result_place;
  if (result.valid()) {
    out_ += "Value<decltype(" + places_.Load(result) + ")> " + ValueName(id) + "{};\n";
  }
  out_ += "if (Any(" + Mask() + ")) {\n";
  std::string restore;
  if (is_partition) {
    const std::set<LocalByte> kept = locals_.Kept(routine_, call.routine);
    for (const auto& [first, count] : PlanesOf(kept)) {
      const std::string name = NewName("k");
      const std::string range = "(m, " + std::to_string(first) + ", " + std::to_string(count) + ", " + name + ");\n";
      out_ += "Plane " + name + "[" + std::to_string(count) + "]; KeepPlanes" + range;
      restore += "PutBackPlanes" + range;
    }
    for (const uint32_t scalar : ScalarsOf(kept)) {
      const std::string name = NewName("k"), at = "m.scalars[" + std::to_string(scalar) + "]";
      out_ += "const uint8_t " + name + " = " + at + ";\n";
      restore += at + " = " + name + ";\n";
    }
    out_ += ClearLocals(call.routine, Mask());
  }
  for (size_t i = 0; i < call.arguments.size() && i < routine.parameter_places.size(); ++i)
    StoreInto(routine.parameter_places[i], call.arguments[i]);
  // The parts of the program are mostly executed by all lanes, and have code for that; of others it would be too much.
  const std::string name = "R" + std::to_string(call.routine.index);
  out_ += is_partition ? "Run(" + Mask() + ", [&](const auto& lanes) { " + name + "(m, lanes); });\n"
                       : name + "(m, " + Mask() + ");\n";
  if (result.valid()) out_ += ValueName(id) + " = " + places_.Load(result) + ";\n";
  out_ += restore + "}\n";
}

void RoutineWriter::WriteHostCall(ir::InstId id, const ir::Inst& inst) {
  const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
  const ir::HostFunction& function = program_.host_functions[call.host];
  if (call.host == program_.schedule.now) {
    out_ += "const auto " + ValueName(id) + " = Now(m);\n";
    return;
  }
  Count(share_, true);
  const std::string frame = NewName("h");
  const bool gives = function.result != ir::Type::kNone;
  if (gives) {
    const bool is_bit = function.result == ir::Type::kBit;
    out_ += (is_bit ? "Plane " : "Bits<" + WidthText(function.result) + "> ") + ValueName(id) + "_bits{};\n";
  }
  const char* const answers = gives              ? (call.out.valid() ? "kBoth" : "kResult")
                              : call.out.valid() ? "kSecond"
                                                 : "kNothing";
  out_ += "if (Any(" + Mask() + ")) {\nHostCall<" + std::to_string(call.arguments.size()) + ", Gives::" + answers +
          "> " + frame + ";\n";
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    const std::string type(ir::CppName(program_[call.arguments[i]].type));
    out_ += frame + ".template Argument<" + type + ">(" + std::to_string(i) + ", " +
            RowsOf(program_, call.arguments[i]) + ");\n";
  }
  out_ += frame + ".Make(m, " + std::to_string(call.host.index) + ", " + Mask() + ");\n";
  if (gives) {
    const bool is_bit = function.result == ir::Type::kBit;
    out_ += ValueName(id) + "_bits = " + frame + ".template Result<" + (is_bit ? "1" : WidthText(function.result)) +
            ">()" + (is_bit ? ".p[0]" : "") + ";\n";
  }
  if (call.out.valid()) {
    const ir::Type type = program_.places[call.out].type;
    const bool is_bit = type == ir::Type::kBit;
    const std::string second =
        frame + ".template Second<" + (is_bit ? "1" : WidthText(type)) + ">()" + (is_bit ? ".p[0]" : "");
    out_ += places_.Store(call.out, ir::ValueId(), second, frame + ".HasSecond(" + Mask() + ")") + "\n";
  }
  out_ += "}\n";
  if (!gives) return;
  const std::string bits = ValueName(id) + "_bits";
  const bool is_float = function.result == ir::Type::kF32 || function.result == ir::Type::kF64;
  out_ += "const auto& " + ValueName(id) + " = " +
          (is_float ? "AsFloat<" + std::string(ir::CppName(function.result)) + ">(" + bits + ")" : bits) + ";\n";
}

}  // namespace plcxx::fleet
