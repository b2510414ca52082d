#include "transpiler/dialects/hnc/parser/clang/body_keeper.h"

#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/dialects/hnc/parser/clang/function_converter.h"
#include "transpiler/dialects/hnc/parser/clang/statement_converter.h"
#include "transpiler/dialects/hnc/parser/clang/variable_converter.h"

namespace plcxx::hnc {
namespace {

template <class Map, class Declaration>
void AddName(Map& map, const clang::IdentifierInfo* name, const Declaration* declaration) {
  const auto [at, is_new] = map.try_emplace(name, declaration);
  if (!is_new && at->second != declaration) at->second = nullptr;
}

template <class Declaration>
const Declaration* FindName(const FileNames::ByName<Declaration>& map, const clang::IdentifierInfo& name) {
  const auto found = map.find(&name);
  return found == map.end() ? nullptr : found->second;
}

source::Range Moved(source::Range range, source::Offset distance) {
  if (range.begin == 0) return range;
  return {range.begin + distance, range.end + distance};
}

template <class IdType>
IdType Moved(IdType id, uint32_t first_before, uint32_t first) {
  return id.valid() ? IdType(id.index - first_before + first) : id;
}

}  // namespace

void FileNames::Add(const clang::NamedDecl* declaration) {
  const clang::IdentifierInfo* name = declaration->getIdentifier();
  if (name == nullptr) return;
  if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) {
    AddName(functions, name, function->getCanonicalDecl());
  } else if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(declaration)) {
    AddName(variables, name, variable->getCanonicalDecl());
  } else if (const auto* record = llvm::dyn_cast<clang::RecordDecl>(declaration)) {
    AddName(tags, name, llvm::cast<clang::RecordDecl>(record->getCanonicalDecl()));
  } else if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(declaration)) {
    const auto* type = alias->getUnderlyingType()->getAs<clang::RecordType>();
    if (type != nullptr && type->getDecl()->getIdentifier() == nullptr &&
        type->getDecl()->getTypedefNameForAnonDecl() == alias) {
      AddName(typedefs, name, llvm::cast<clang::RecordDecl>(type->getDecl()->getCanonicalDecl()));
    }
  }
}

bool BodyKeeper::CollectNames() {
  if (!session_.input.keeps_bodies) return true;
  for (const clang::Decl* declaration : context_.getTranslationUnitDecl()->decls()) {
    if (const auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration)) now_.recorder.names.Add(named);
  }
  environment_.Collect();
  if (session_.input.kept == nullptr) return true;
  if (session_.input.kept->is_changed_outside) FindStaleBodies();
  if (!session_.output.stale_bodies.empty()) return false;
  known_types_.resize(Before().types.size());
  known_functions_.resize(Before().functions.size());
  known_variables_.resize(Before().variables.size());
  return true;
}

uint32_t BodyKeeper::ElidedOf(const clang::FunctionDecl* function) const {
  const auto* block = llvm::dyn_cast_or_null<clang::CompoundStmt>(function->getBody());
  if (block == nullptr || !block->getLBracLoc().isFileID()) return Session::kNotElided;
  return session_.ElidedAt(session_.places.Of(block->getLBracLoc()));
}

/// What an error in front of it has come into is read again, too: the parser may have gone on in the middle of it.
void BodyKeeper::FindStaleBodies() {
  const KeptBodies& kept = *session_.input.kept;
  std::vector<bool> is_fresh(kept.elided.size());
  for (const clang::Decl* declaration : context_.getTranslationUnitDecl()->decls()) {
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration);
    if (function == nullptr || !function->doesThisDeclarationHaveABody()) continue;
    const uint32_t elided = ElidedOf(function);
    if (elided == Session::kNotElided || session_.unclean.contains(function)) continue;
    const FunctionBody& body = (*kept.bodies)[kept.elided[elided].body];
    is_fresh[elided] = body.environment != 0 && environment_.Of(function, *body.words) == body.environment;
  }
  for (size_t i = 0; i < kept.elided.size(); ++i) {
    if (!is_fresh[i]) session_.output.stale_bodies.push_back(kept.elided[i].body);
  }
}

StatementId BodyKeeper::BodyOf(const clang::FunctionDecl* function) {
  const auto* block = llvm::dyn_cast_or_null<clang::CompoundStmt>(function->getBody());
  // Defined twice, it has the parameters of one of its bodies.
  const bool is_repeated = unit_.functions[now_.function].body.valid();
  if (!session_.input.keeps_bodies || block == nullptr || is_repeated) {
    session_.output.can_keep = false;
    return statements_.ConvertBody(function);
  }
  const clang::SourceLocation open = block->getLBracLoc(), close = block->getRBracLoc();
  FunctionBody body;
  body.function = now_.function;
  body.inside = {session_.places.Of(open) + 1, session_.places.Of(close)};
  const bool is_plain = open.isValid() && open.isFileID() && close.isValid() && close.isFileID() &&
                        body.inside.begin > 1 && body.inside.begin <= body.inside.end;
  if (!is_plain) session_.output.can_keep = session_.output.kept_fits = false;
  const uint32_t elided = is_plain ? session_.ElidedAt(body.inside.begin - 1) : Session::kNotElided;
  if (elided == Session::kNotElided) return Record(function, std::move(body), is_plain);
  const ElidedBody& passed = session_.input.kept->elided[elided];
  const bool is_passed = elided < session_.elided_uses.size() && session_.elided_uses[elided] != Session::kNotElided &&
                         block->body_empty();
  if (!is_passed || passed.inside.end != body.inside.end || session_.unclean.contains(function)) Misfit();
  if (!session_.output.kept_fits) return statements_.ConvertBody(function);
  return TakeOver((*session_.input.kept->bodies)[passed.body], elided);
}

StatementId BodyKeeper::Record(const clang::FunctionDecl* function, FunctionBody body, bool is_plain) {
  const auto sizes = [&] {
    return std::array<uint32_t, 5>{unit_.expressions.size(), unit_.statements.size(), unit_.labels.size(),
                                   static_cast<uint32_t>(unit_.strings.size()), unit_.statement_count};
  };
  const auto before = sizes();
  const size_t found = findings().all().size();
  now_.recorder.Begin(static_cast<uint32_t>(session_.output.bodies.size()));
  const StatementId root = statements_.ConvertBody(function);
  body.needs = now_.recorder.End();
  const auto after = sizes();
  body.words = environment_.WordsOf(llvm::cast<clang::CompoundStmt>(function->getBody()));
  if (is_plain && body.words != nullptr) body.environment = environment_.Of(function, *body.words);
  body.expressions = {before[0], after[0] - before[0]};
  body.statements = {before[1], after[1] - before[1]};
  body.labels = {before[2], after[2] - before[2]};
  body.strings = {before[3], after[3] - before[3]};
  body.statement_count = after[4] - before[4];
  body.root = root;
  body.is_reusable = is_plain && now_.recorder.is_reusable() && found == findings().all().size() &&
                     !session_.unclean.contains(function) && !function->isInvalidDecl() && AllInside(body);
  session_.output.bodies.push_back(std::move(body));
  return root;
}

bool BodyKeeper::AllInside(const FunctionBody& body) const {
  const auto inside = [&](source::Range range) {
    return range.begin == 0 || (range.begin + 1 >= body.inside.begin && range.end <= body.inside.end + 1);
  };
  for (uint32_t i = 0; i < body.expressions.count; ++i) {
    const Expr& expr = unit_.expressions[ExprId(body.expressions.first + i)];
    if (!inside(expr.range) || !inside(expr.op)) return false;
  }
  for (uint32_t i = 0; i < body.statements.count; ++i) {
    const Statement& statement = unit_.statements[StatementId(body.statements.first + i)];
    if (!inside(statement.range) || !inside(statement.head) || !inside(statement.keyword) || !inside(statement.close) ||
        !inside(statement.otherwise_keyword) || (statement.loop_bound && !inside(statement.loop_bound->range))) {
      return false;
    }
  }
  return true;
}

template <class Declaration>
const Declaration* BodyKeeper::Declared(const FileNames::ByName<Declaration>& names, const std::string& name) {
  const Declaration* found = FindName(names, context_.Idents.get(name));
  if (found == nullptr) Misfit();
  return found;
}

void BodyKeeper::Satisfy(const Need& need) {
  switch (need.kind) {
    case NeedKind::kType:
      if (known_types_[need.id].valid()) return;
      {
        Type type = Before().types[TypeId(need.id)];
        if (!need.text.empty()) type.text = need.text;
        if (type.element.valid()) type.element = TypeOf(type.element);
        known_types_[need.id] = types_.Add(std::move(type));
      }
      return;
    case NeedKind::kTaggedRecord:
    case NeedKind::kTypedefRecord: {
      if (known_types_[need.id].valid()) return;
      const FileNames& names = now_.recorder.names;
      const auto* record = Declared(need.kind == NeedKind::kTaggedRecord ? names.tags : names.typedefs, need.text);
      if (record == nullptr) return;
      known_types_[need.id] = types_.TypeOf(context_.getRecordType(record));
      return;
    }
    case NeedKind::kFunction:
      FunctionOf(FunctionId(need.id));
      return;
    case NeedKind::kFileVariable:
      VariableOf(VariableId(need.id));
      return;
    case NeedKind::kLocal:
      known_variables_[need.id] = unit_.variables.Add({});
      return;
  }
}

/// Beside those that the body names: such as were there before it, of what it refers to.
TypeId BodyKeeper::TypeOf(TypeId before) {
  if (!before.valid()) return before;
  TypeId& known = known_types_[before.index];
  if (known.valid()) return known;
  Type type = Before().types[before];
  const uint32_t count = unit_.types.size();
  if (type.element.valid()) type.element = TypeOf(type.element);
  if (type.record.valid()) {
    const clang::IdentifierInfo& name = context_.Idents.get(Before().records[type.record].name);
    const FileNames& names = now_.recorder.names;
    const clang::RecordDecl* tagged = FindName(names.tags, name);
    const clang::RecordDecl* alias = FindName(names.typedefs, name);
    if ((tagged == nullptr) == (alias == nullptr)) {
      Misfit();
      return {};
    }
    type.record = types_.RecordOf(tagged != nullptr ? tagged : alias);
  }
  known = types_.Add(std::move(type));
  if (unit_.types.size() != count) Misfit();
  return known;
}

FunctionId BodyKeeper::FunctionOf(FunctionId before) {
  if (!before.valid()) return before;
  FunctionId& known = known_functions_[before.index];
  if (known.valid()) return known;
  const auto* function = Declared(now_.recorder.names.functions, Before().functions[before].name);
  if (function == nullptr) return {};
  return known = functions_.FunctionOf(function);
}

VariableId BodyKeeper::VariableOf(VariableId before) {
  if (!before.valid()) return before;
  VariableId& known = known_variables_[before.index];
  if (known.valid()) return known;
  const auto* variable = Declared(now_.recorder.names.variables, Before().variables[before].name);
  if (variable == nullptr) return {};
  const uint32_t expressions = unit_.expressions.size();
  known = variables_.VariableOf(variable);
  if (unit_.expressions.size() != expressions || unit_.variables[known].storage == Storage::kUndefined) Misfit();
  return known;
}

void BodyKeeper::TakeVariable(VariableId before, source::Offset distance, ExprId first_expression,
                              ExprId first_before) {
  Variable variable = std::move(Before().variables[before]);
  variable.type = TypeOf(variable.type);
  variable.function = now_.function;
  variable.range = Moved(variable.range, distance);
  for (InitialValue& initial : variable.initial) {
    initial.type = TypeOf(initial.type);
    initial.value = Moved(initial.value, first_before.index, first_expression.index);
  }
  unit_.variables[known_variables_[before.index]] = std::move(variable);
}

void BodyKeeper::TakeExpressions(const FunctionBody& body, source::Offset distance, uint32_t first_use) {
  const uint32_t first_before = body.expressions.first, first = unit_.expressions.size();
  const uint32_t first_string = static_cast<uint32_t>(unit_.strings.size());
  for (uint32_t i = 0; i < body.strings.count; ++i) {
    unit_.strings.push_back(std::move(Before().strings[body.strings.first + i]));
  }
  for (uint32_t i = 0; i < body.expressions.count; ++i) {
    Expr expr = std::move(Before().expressions[ExprId(first_before + i)]);
    expr.type = TypeOf(expr.type);
    expr.computation = TypeOf(expr.computation);
    expr.range = Moved(expr.range, distance);
    expr.op = Moved(expr.op, distance);
    for (ExprId* part : {&expr.a, &expr.b, &expr.c}) *part = Moved(*part, first_before, first);
    for (ExprId& argument : expr.arguments) argument = Moved(argument, first_before, first);
    expr.variable = VariableOf(expr.variable);
    expr.function = FunctionOf(expr.function);
    if (expr.kind == ExprKind::kString) expr.string = expr.string - body.strings.first + first_string;
    expr.macro = Moved(expr.macro, body.macro_uses.first, first_use);
    unit_.expressions.Add(std::move(expr));
  }
}

void BodyKeeper::TakeStatements(const FunctionBody& body, source::Offset distance, uint32_t first_use) {
  const uint32_t first_before = body.statements.first, first = unit_.statements.size();
  const uint32_t expressions = unit_.expressions.size() - body.expressions.count;
  const uint32_t first_label = unit_.labels.size();
  for (uint32_t i = 0; i < body.labels.count; ++i) {
    Label label = std::move(Before().labels[LabelId(body.labels.first + i)]);
    label.range = Moved(label.range, distance);
    label.statement = Moved(label.statement, first_before, first);
    unit_.functions[now_.function].labels.push_back(unit_.labels.Add(std::move(label)));
  }
  for (uint32_t i = 0; i < body.statements.count; ++i) {
    Statement statement = std::move(Before().statements[StatementId(first_before + i)]);
    for (ExprId* part : {&statement.expression, &statement.first, &statement.step, &statement.case_expression}) {
      *part = Moved(*part, body.expressions.first, expressions);
    }
    for (StatementId* part : {&statement.then, &statement.otherwise}) *part = Moved(*part, first_before, first);
    for (StatementId& inner : statement.body) inner = Moved(inner, first_before, first);
    for (VariableId& variable : statement.variables) variable = VariableOf(variable);
    statement.label = Moved(statement.label, body.labels.first, first_label);
    for (source::Range* range :
         {&statement.range, &statement.head, &statement.keyword, &statement.close, &statement.otherwise_keyword}) {
      *range = Moved(*range, distance);
    }
    if (statement.loop_bound) statement.loop_bound->range = Moved(statement.loop_bound->range, distance);
    statement.macro = Moved(statement.macro, body.macro_uses.first, first_use);
    unit_.statements.Add(std::move(statement));
  }
}

StatementId BodyKeeper::TakeOver(const FunctionBody& body, uint32_t elided) {
  const ElidedBody& passed = session_.input.kept->elided[elided];
  const source::Offset distance = passed.inside.begin - body.inside.begin;
  const uint32_t first_use = session_.elided_uses[elided];
  const Function& before = Before().functions[body.function];
  const std::vector<VariableId>& parameters = unit_.functions[now_.function].parameters;
  if (parameters.size() != before.parameters.size() || unit_.functions[now_.function].name != before.name) Misfit();
  for (size_t i = 0; i < std::min(parameters.size(), before.parameters.size()); ++i) {
    known_variables_[before.parameters[i].index] = parameters[i];
  }
  unit_.functions[now_.function].clang_differs = before.clang_differs;
  for (const Need& need : body.needs) Satisfy(need);
  const uint32_t strings = static_cast<uint32_t>(unit_.strings.size());
  const ExprId expressions(unit_.expressions.size());
  const uint32_t statements = unit_.statements.size(), labels = unit_.labels.size();
  for (const Need& need : body.needs) {
    if (need.kind != NeedKind::kLocal) continue;
    TakeVariable(VariableId(need.id), distance, expressions, ExprId(body.expressions.first));
  }
  for (const VariableId local : before.locals) unit_.functions[now_.function].locals.push_back(VariableOf(local));
  TakeExpressions(body, distance, first_use);
  TakeStatements(body, distance, first_use);
  unit_.statement_count += body.statement_count;
  FunctionBody made = body;
  for (Need& need : made.needs) {
    switch (need.kind) {
      case NeedKind::kType:
      case NeedKind::kTaggedRecord:
      case NeedKind::kTypedefRecord:
        need.id = known_types_[need.id].index;
        break;
      case NeedKind::kFunction:
        need.id = known_functions_[need.id].index;
        break;
      case NeedKind::kFileVariable:
      case NeedKind::kLocal:
        need.id = known_variables_[need.id].index;
        break;
    }
  }
  made.inside = passed.inside;
  made.was_taken_over = true;
  made.function = now_.function;
  made.expressions.first = expressions.index;
  made.statements.first = statements;
  made.labels.first = labels;
  made.strings.first = strings;
  made.macro_uses.first = first_use;
  made.root = Moved(body.root, body.statements.first, statements);
  const StatementId root = made.root;
  session_.output.bodies.push_back(std::move(made));
  return root;
}

}  // namespace plcxx::hnc
