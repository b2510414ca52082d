#include "transpiler/dialects/prostep/parser/module_reader.h"

#include <utility>

namespace plcxx::prostep {
namespace {

std::string ModuleName(uint32_t number) { return "PM " + std::to_string(number); }

}  // namespace

std::optional<uint32_t> ModuleReader::ModuleNumber(const Statement& statement) {
  const std::string mark = UpperOf(statement.tokens.front());
  if (statement.tokens.size() == 1) {
    diagnostics_.Report(statement.range, diag::ProstepOperandNone, mark, "PM and a number");
    return std::nullopt;
  }
  if (IsReported(statement)) return std::nullopt;
  const OperandClass operand_class = operands_.ClassOf(statement.tokens, 1);
  if (operand_class != OperandClass::kPM) {
    const source::Range range = {statement.tokens[1].range.begin, statement.range.end};
    const std::string text = operands_.OperandText(statement.tokens, 1);
    if (operand_class == OperandClass::kNone) {
      diagnostics_.Report(range, diag::ProstepOperandUnknown, text, mark, "PM and a number");
    } else {
      diagnostics_.Report(range, diag::ProstepOperandNotAllowed, text, mark, "PM and a number");
    }
    return std::nullopt;
  }
  const Operand operand = operands_.ReadOperand(statement.tokens, 1);
  if (!operand.exists()) return std::nullopt;
  return operand.number;
}

/// A module whose number is wrong is closed with the same wrong number.
std::optional<uint32_t> ModuleReader::ClosedNumber(const Statement& statement) {
  const bool same = now_.module.valid() && program_.modules[now_.module].faulty && statement.tokens.size() > 1 &&
                    operands_.OperandText(statement.tokens, 1) == faulty_module_;
  return same ? std::nullopt : ModuleNumber(statement);
}

void ModuleReader::OpenModule(const Statement& statement) {
  const Span comments = comments_.TakeComments();
  outside_ = twice_ = false;
  const Token* label = labels_.TheLabel(statement);
  if (label != nullptr) diagnostics_.Report(label->range, diag::ProstepLabelOnModule, TextOf(*label));
  const auto number = ModuleNumber(statement);
  faulty_module_ = number ? "" : operands_.OperandText(statement.tokens, 1);
  bool reported = label != nullptr || !number;
  if (now_.module.valid()) {
    const Module& outer = program_.modules[now_.module];
    if (number && !now_.meant_end) {
      diagnostics_
          .Report(statement.range, diag::ProstepModuleInside, ModuleName(*number),
                  outer.faulty ? "a module" : ModuleName(outer.number))
          .notes.push_back({outer.open, "the open module begins here"});
      reported = true;
    }
    if (!outer.faulty) abandoned_.insert(outer.number);
    forgiving_ = true;
    LeaveModule({});
  } else {
    forgiving_ = false;
  }

  Module module{.number = static_cast<uint8_t>(number.value_or(0)),
                .faulty = !number,
                .numbered = number.has_value(),
                .file = now_.file,
                .open = statement.range,
                .instructions = {.first = program_.instructions.size()},
                .labels = {.first = program_.labels.size()},
                .comments = comments};
  comments_.AttachTrailing(module.comments, statement.comment);
  instructions_.WarnOfComment(statement, false);
  now_.module = program_.modules.Add(module);
  now_.seen_module = true;
  brackets_.BeginModule();
  if (!number) return;
  ModuleId& first = program_.module_of[*number];
  if (!first.valid()) {
    first = now_.module;
  } else if (!reported) {
    diagnostics_.Report(statement.range, diag::ProstepModuleTwice, ModuleName(*number))
        .notes.push_back({program_.modules[first].open, "first defined here"});
    twice_ = true;
  }
}

void ModuleReader::CloseModule(const Statement& statement) {
  const Token* label = labels_.TheLabel(statement);
  const auto number = ClosedNumber(statement);
  instructions_.WarnOfComment(statement, false);
  const bool abandoned = number && abandoned_.contains(*number);
  const bool outside = std::exchange(outside_, false);
  if (!now_.module.valid()) {
    const Span comments = comments_.TakeComments();
    Span ignored = comments;
    comments_.AttachTrailing(ignored, statement.comment);
    if (abandoned) {
      abandoned_.erase(*number);
    } else if (number && !outside) {
      diagnostics_.Report(statement.range, diag::ProstepEndWithoutModule, ModuleName(*number));
    }
    return;
  }
  Module& module = program_.modules[now_.module];
  if (number && !module.faulty && *number != module.number) {
    if (abandoned) {
      abandoned_.erase(*number);
      abandoned_.insert(module.number);
    } else if (!twice_) {  // else its MOD has the wrong number
      diagnostics_.Report(statement.range, diag::ProstepEndMismatch, ModuleName(*number), ModuleName(module.number))
          .notes.push_back({module.open, "the open module begins here"});
    }
  }
  if (label != nullptr) labels_.DefineLabel(*label);
  brackets_.EndModule(statement.range, "END" + (number ? " " + ModuleName(*number) : ""));
  module.end_comments = comments_.TakeComments();
  comments_.AttachTrailing(module.end_comments, statement.comment);
  LeaveModule(statement.range);
}

void ModuleReader::LeaveModule(source::Range close) {
  Module& module = program_.modules[now_.module];
  module.close = close;
  now_.meant_end = false;
  module.instructions.count = program_.instructions.size() - module.instructions.first;
  module.labels.count = program_.labels.size() - module.labels.first;
  labels_.EndModule(module);
  now_.module = ModuleId();
}

void ModuleReader::EndFile() {
  if (now_.module.valid()) {
    const Module& module = program_.modules[now_.module];
    if (!module.faulty) diagnostics_.Report(module.open, diag::ProstepModuleNotClosed, ModuleName(module.number));
    LeaveModule({});
  }
  abandoned_.clear();
  forgiving_ = outside_ = false;
  program_.files.back().rest = comments_.TakeComments();
}

}  // namespace plcxx::prostep
