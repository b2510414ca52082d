// MOD and END (specification 4.1, recovery of section 10).
#include "transpiler/dialects/prostep/parser/internal.h"

namespace plcxx::prostep {
namespace {

std::string ModuleName(uint32_t number) { return "PM " + std::to_string(number); }

}  // namespace

std::optional<uint32_t> Parser::ModuleNumber(const Statement& statement) {
  const std::string mark = UpperOf(statement.tokens.front());
  if (statement.tokens.size() == 1) {
    diagnostics_.Report(statement.range, diag::ProstepOperandNone, mark, "PM and a number");
    return std::nullopt;
  }
  if (IsReported(statement)) return std::nullopt;
  const OperandClass operand_class = ClassOf(statement.tokens, 1);
  if (operand_class != OperandClass::kPM) {
    const source::Range range = {statement.tokens[1].range.begin, statement.range.end};
    const std::string text = OperandText(statement.tokens, 1);
    if (operand_class == OperandClass::kNone) {
      diagnostics_.Report(range, diag::ProstepOperandUnknown, text, mark, "PM and a number");
    } else {
      diagnostics_.Report(range, diag::ProstepOperandNotAllowed, text, mark, "PM and a number");
    }
    return std::nullopt;
  }
  const Operand operand = ReadOperand(statement.tokens, 1);
  if (!operand.exists()) return std::nullopt;
  return operand.number;
}

/// A module whose number is wrong is closed with the same wrong number.
std::optional<uint32_t> Parser::ClosedNumber(const Statement& statement) {
  const bool same = module_.valid() && program_.modules[module_].faulty && statement.tokens.size() > 1 &&
                    OperandText(statement.tokens, 1) == faulty_module_;
  return same ? std::nullopt : ModuleNumber(statement);
}

void Parser::OpenModule(const Statement& statement) {
  const Span comments = TakeComments();
  const Token* label = TheLabel(statement);
  if (label != nullptr) diagnostics_.Report(label->range, diag::ProstepLabelOnModule, TextOf(*label));
  const auto number = ModuleNumber(statement);
  faulty_module_ = number ? "" : OperandText(statement.tokens, 1);
  bool reported = label != nullptr || !number;
  if (module_.valid()) {
    const Module& outer = program_.modules[module_];
    if (number) {
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
                .file = file_,
                .open = statement.range,
                .instructions = {.first = program_.instructions.size()},
                .labels = {.first = program_.labels.size()},
                .comments = comments};
  AttachTrailing(module.comments, statement.comment);
  WarnOfComment(statement, false);
  module_ = program_.modules.Add(module);
  seen_module_ = true;
  brackets_.BeginModule();
  if (!number) return;
  ModuleId& first = program_.module_of[*number];
  if (!first.valid()) {
    first = module_;
  } else if (!reported) {
    diagnostics_.Report(statement.range, diag::ProstepModuleTwice, ModuleName(*number))
        .notes.push_back({program_.modules[first].open, "first defined here"});
  }
}

void Parser::CloseModule(const Statement& statement) {
  const Token* label = TheLabel(statement);
  const auto number = ClosedNumber(statement);
  WarnOfComment(statement, false);
  const bool abandoned = number && abandoned_.contains(*number);
  if (!module_.valid()) {
    const Span comments = TakeComments();
    Span ignored = comments;
    AttachTrailing(ignored, statement.comment);
    if (abandoned) {
      abandoned_.erase(*number);
    } else if (number) {
      diagnostics_.Report(statement.range, diag::ProstepEndWithoutModule, ModuleName(*number));
    }
    return;
  }
  Module& module = program_.modules[module_];
  if (number && !module.faulty && *number != module.number) {
    if (abandoned) {
      abandoned_.erase(*number);
      abandoned_.insert(module.number);
    } else {
      diagnostics_.Report(statement.range, diag::ProstepEndMismatch, ModuleName(*number), ModuleName(module.number))
          .notes.push_back({module.open, "the open module begins here"});
    }
  }
  if (label != nullptr) DefineLabel(*label);
  brackets_.EndModule(statement.range, "END" + (number ? " " + ModuleName(*number) : ""));
  module.end_comments = TakeComments();
  AttachTrailing(module.end_comments, statement.comment);
  LeaveModule(statement.range);
}

void Parser::LeaveModule(source::Range close) {
  Module& module = program_.modules[module_];
  module.close = close;
  module.instructions.count = program_.instructions.size() - module.instructions.first;
  module.labels.count = program_.labels.size() - module.labels.first;
  ResolveJumps(module);
  labels_.clear();
  jumps_.clear();
  module_ = ModuleId();
}

void Parser::ResolveJumps(const Module& module) {
  for (const PendingJump& jump : jumps_) {
    const auto label = labels_.find(jump.name);
    if (label == labels_.end()) {
      program_.instructions[jump.instruction].faulty = true;
      diagnostics_.Report(jump.range, diag::ProstepLabelUndefined, jump.name);
      continue;
    }
    program_.instructions[jump.instruction].target = label->second;
    ++program_.labels[label->second].uses;
  }
  // Labels in front of END stand after the last instruction: where the module ends.
  PLCXX_CHECK(module.labels.first + module.labels.count == program_.labels.size());
}

void Parser::EndOfFile() {
  FinishWaiting();
  if (module_.valid()) {
    const Module& module = program_.modules[module_];
    if (!module.faulty) diagnostics_.Report(module.open, diag::ProstepModuleNotClosed, ModuleName(module.number));
    LeaveModule({});
  }
  abandoned_.clear();
  forgiving_ = false;
  program_.files.back().rest = TakeComments();
}

}  // namespace plcxx::prostep
