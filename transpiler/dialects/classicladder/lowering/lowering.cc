#include "transpiler/dialects/classicladder/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/classicladder/lowering/internal.h"
#include "transpiler/dialects/common/statement_texts.h"

namespace plcxx::classicladder {

using ir::ValueId;

/// The subroutines that a section's rungs call, and those that these call.
void Lowering::AddCalledRoutines(const Section& section) {
  for (const uint32_t number : ChainOf(tree_, section)) {
    for (const auto& row : tree_.rungs.at(number).rows) {
      for (const Element& element : row) {
        if (element.kind != ElementKind::kCall) continue;
        const Section* called = SubroutineOf(tree_, element.number);
        if (called == nullptr || routines_.contains(called->number)) continue;
        const std::string name = "SR" + std::to_string(called->subroutine);
        routines_[called->number] =
            builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, "Subroutine " + name + ": " + called->name);
        called_.push_back(called);
        AddCalledRoutines(*called);
      }
    }
  }
}

/// Of the first coil or block.
std::string Lowering::SubjectOf(const Rung& rung) const {
  for (const auto& row : rung.rows) {
    for (const Element& element : row) {
      switch (element.kind) {
        case ElementKind::kCoil:
        case ElementKind::kCoilNot:
        case ElementKind::kSet:
        case ElementKind::kReset:
          return NameInCode(element.variable.address);
        case ElementKind::kTimer:
          return "T" + std::to_string(element.number);
        case ElementKind::kMonostable:
          return "M" + std::to_string(element.number);
        case ElementKind::kCounter:
          return "C" + std::to_string(element.number);
        case ElementKind::kTimerIec:
          return "TM" + std::to_string(element.number);
        case ElementKind::kOperate: {
          const Expression& operation = tree_.operations.at(element.number);
          if (!operation.empty) return NameInCode(operation.target.address);
          break;
        }
        case ElementKind::kCall:
          return "SR" + std::to_string(element.number);
        case ElementKind::kFree:
        case ElementKind::kContact:
        case ElementKind::kContactNot:
        case ElementKind::kRising:
        case ElementKind::kFalling:
        case ElementKind::kWire:
        case ElementKind::kCompare:
        case ElementKind::kJump:
        case ElementKind::kPart:
          break;
      }
    }
  }
  return "rung" + std::to_string(rung.number);
}

/// A rung is a statement: its rows down to the last one that has something.
void Lowering::AddStatement(const Rung& rung) {
  size_t rows = 0;
  for (size_t y = 0; y < rung.lines.size(); ++y) {
    for (const Element& element : rung.rows[y]) {
      if (element.kind != ElementKind::kFree) rows = y + 1;
    }
  }
  const source::Range range = rows == 0 ? rung.range : source::Range{rung.lines[0].begin, rung.lines[rows - 1].end};
  dialects::TextHash hash;
  for (const char c : sources_.Text(range)) {
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') hash.Add(c);
  }
  std::vector<source::Range> comments;
  if (rung.label_range.end > rung.label_range.begin) comments.push_back(rung.label_range);
  if (rung.comment_range.end > rung.comment_range.begin) comments.push_back(rung.comment_range);
  const ir::StatementId statement = program_.statements.Add(
      {.range = range, .comments = std::move(comments), .subject = SubjectOf(rung), .id = statement_ids_.Next(hash)});
  builder_.SetRange(range);
  builder_.Statement(statement);
}

uint32_t Lowering::LabelOf(uint32_t rung) {
  const auto [found, is_new] = now_.labels.try_emplace(rung, next_label_);
  if (is_new) ++next_label_;
  return found->second;
}

/// After the last jump that the engine takes: it ends the section, and stands still from the next period on.
void Lowering::RefuseJump() {
  builder_.Store(stopped_, builder_.Bit(1));
  CallFault(Fault::kJumpLoop);
  now_.end_is_used = true;
  builder_.Jump(now_.end_label);
}

/// False: always taken.
bool Lowering::Jump(Signal condition, uint32_t rung) {
  if (condition.kind == Signal::Kind::kZero) return true;
  const ValueId taken = condition.kind == Signal::Kind::kOne ? ValueId() : condition.value;
  const auto target = now_.order.find(rung);
  if (target == now_.order.end()) {
    now_.end_is_used = true;
    builder_.Jump(now_.end_label, taken);
  } else if (target->second <= now_.position) {
    const ir::RegionId refused = builder_.RegionOf([this] { RefuseJump(); });
    builder_.JumpBack(LabelOf(rung), taken, now_.jumps_left, refused);
  } else if (!now_.jumps_left.valid()) {
    builder_.Jump(LabelOf(rung), taken);
  } else {
    // The engine counts jumps forward, too.
    When(condition, [&] {
      const ValueId left = builder_.Load(now_.jumps_left);
      const ValueId none = builder_.Pure(ir::OpKind::kEqual32, {left, Word(0)});
      builder_.When(none, [&] { RefuseJump(); });
      builder_.Store(now_.jumps_left, builder_.Pure(ir::OpKind::kSub32, {left, Word(1)}));
      builder_.Jump(LabelOf(rung));
    });
  }
  return taken.valid();
}

bool Lowering::Execute(uint32_t x, uint32_t y, const Element& element) {
  builder_.SetRange(element.range);
  switch (element.kind) {
    case ElementKind::kFree:
    case ElementKind::kPart:
      return true;  // keeps what a block above has put here
    case ElementKind::kContact:
    case ElementKind::kContactNot:
    case ElementKind::kRising:
    case ElementKind::kFalling:
      Contact(x, y, element);
      return true;
    case ElementKind::kWire:
      now_.outputs[x][y] = Left(x, y);
      return true;
    case ElementKind::kTimer:
      Timer(x, y, element.number);
      return true;
    case ElementKind::kMonostable:
      Monostable(x, y, element.number);
      return true;
    case ElementKind::kCounter:
      Counter(x, y, element.number);
      return true;
    case ElementKind::kTimerIec:
      TimerIec(x, y, element.number);
      return true;
    case ElementKind::kCompare: {
      const Signal before = Left(x - 2, y);
      now_.outputs[x][y] = And(before, Compare(element.number));
      return true;
    }
    case ElementKind::kCoil:
    case ElementKind::kCoilNot:
    case ElementKind::kSet:
    case ElementKind::kReset:
      Coil(x, y, element);
      return true;
    case ElementKind::kJump:
      return Jump(Left(x, y), element.number);
    case ElementKind::kCall: {
      const Section* called = SubroutineOf(tree_, element.number);
      if (called == nullptr) return true;
      When(Left(x, y), [&] { builder_.CallRoutine(routines_.at(called->number), {}); });
      return true;
    }
    case ElementKind::kOperate:
      When(Left(x - 2, y), [&] { Operate(element.number); });
      return true;
  }
  PLCXX_UNREACHABLE();
}

void Lowering::LowerRung(const Rung& rung) {
  now_.rung = &rung;
  for (uint32_t x = 0; x < kRungWidth; ++x) {
    for (uint32_t y = 0; y < kRungHeight; ++y) {
      now_.outputs[x][y] = {};
      now_.knows_left[x][y] = false;
    }
  }
  AddStatement(rung);
  for (uint32_t x = 0; x < kRungWidth; ++x) {
    for (uint32_t y = 0; y < kRungHeight; ++y) {
      if (!Execute(x, y, rung.At(x, y))) return;
    }
  }
}

void Lowering::LowerLadder(const Section& section, ir::RegionId body) {
  now_ = {};
  now_.section = &section;
  now_.end_label = next_label_++;
  builder_.SetRegion(body);
  builder_.SetRange({});
  const std::vector<uint32_t> chain = ChainOf(tree_, section);
  for (size_t i = 0; i < chain.size(); ++i) now_.order[chain[i]] = i;
  bool goes_back = false;
  std::set<uint32_t> targets;
  for (const uint32_t number : chain) {
    for (const auto& row : tree_.rungs.at(number).rows) {
      for (const Element& element : row) {
        if (element.kind != ElementKind::kJump || !now_.order.contains(element.number)) continue;
        targets.insert(element.number);
        goes_back = goes_back || now_.order[element.number] <= now_.order[number];
      }
    }
  }
  if (goes_back) {
    now_.jumps_left = NewSystemPlace("jumps_left_" + std::to_string(section.number), ir::Type::kI32);
    builder_.Store(now_.jumps_left, Word(kMostJumps));
  }
  for (const uint32_t number : chain) {
    now_.position = now_.order[number];
    builder_.SetRange({});
    if (targets.contains(number)) builder_.Label(LabelOf(number));
    LowerRung(tree_.rungs.at(number));
  }
  builder_.SetRange({});
  if (now_.end_is_used) builder_.Label(now_.end_label);
}

ir::Program Lowering::Run() {
  program_.dialect = "classicladder";
  AddSpaces(program_, tree_.sizes);
  NameSymbols();
  InitialValues();
  AddRoutines();
  for (const auto& [number, section] : tree_.sections) {
    if (section.language == Language::kLadder && section.is_main()) AddCalledRoutines(section);
  }
  const ir::RegionId fast = program_.routines[fast_].body;
  for (const auto& [number, section] : tree_.sections) {
    builder_.SetRegion(fast);
    if (section.language == Language::kSequential) {
      LowerPage(section);
    } else if (section.is_main()) {
      LowerLadder(section, fast);
    }
  }
  for (const Section* section : called_) {
    LowerLadder(*section, program_.routines[routines_.at(section->number)].body);
  }
  RefreshSteps();
  Init();
  Period();
  Schedule();
  Document();
  return std::move(program_);
}

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::classicladder
