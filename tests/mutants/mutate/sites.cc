#include "tests/mutants/mutate/sites.h"

#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "tests/mutants/mutate/needless_jumps.h"

namespace plcxx::mutants {
namespace {

using namespace clang;  // the tree's names, throughout

struct Range {
  unsigned begin = 0, end = 0;
};

struct Spelling {
  const char* function;
  const char* kind;
  const char* negated;  // of a relation: its second mutant
};

std::optional<Spelling> SpellingOf(BinaryOperatorKind op) {
  switch (op) {
    case BO_LT:
      return Spelling{"Less", "< to <=", "< to >="};
    case BO_LE:
      return Spelling{"LessOrEqual", "<= to <", "<= to >"};
    case BO_GT:
      return Spelling{"Greater", "> to >=", "> to <="};
    case BO_GE:
      return Spelling{"GreaterOrEqual", ">= to >", ">= to <"};
    case BO_EQ:
      return Spelling{"Equal", "== to !=", nullptr};
    case BO_NE:
      return Spelling{"Unequal", "!= to ==", nullptr};
    case BO_Add:
      return Spelling{"Plus", "+ to -", nullptr};
    case BO_Sub:
      return Spelling{"Minus", "- to +", nullptr};
    case BO_Mul:
      return Spelling{"Times", "* to +", nullptr};
    case BO_Div:
      return Spelling{"Divided", "/ to *", nullptr};
    case BO_Rem:
      return Spelling{"Remainder", "% to /", nullptr};
    case BO_And:
      return Spelling{"BitAnd", "& to |", nullptr};
    case BO_Or:
      return Spelling{"BitOr", "| to &", nullptr};
    case BO_Xor:
      return Spelling{"BitXor", "^ to |", nullptr};
    case BO_Shl:
      return Spelling{"ShiftLeft", "<< to >>", nullptr};
    case BO_Shr:
      return Spelling{"ShiftRight", ">> to <<", nullptr};
    default:
      return std::nullopt;
  }
}

/// Of calls that are left alone with everything in them.
bool IsExcludedCall(const std::string& name) {
  static const std::set<std::string> names = {"reserve", "Reserve", "shrink_to_fit"};
  return names.contains(name);
}

/// Whose arguments are texts and places for people. That they are made at all is mutated.
bool IsReport(const std::string& name) {
  static const std::set<std::string> names = {"Report", "ReportAt", "Note", "Warn", "Error"};
  return names.contains(name);
}

/// The greater of two numbers is that of them in either order.
bool TakesEitherOrder(const FunctionDecl& function) {
  static const std::set<std::string> names = {"std::max", "std::min"};
  return names.contains(function.getQualifiedNameAsString());
}

class Finder : public RecursiveASTVisitor<Finder> {
  using Base = RecursiveASTVisitor<Finder>;

 public:
  Finder(ASTContext& context, const std::vector<std::string>& files, unsigned first)
      : context_(context), sources_(context.getSourceManager()), files_(files.begin(), files.end()), next_(first) {}

  Rewritten Take() { return std::move(result_); }

  bool TraverseDecl(Decl* decl) {
    if (decl == nullptr || decl->isImplicit()) return true;
    const bool encloses = isa<NamespaceDecl, TranslationUnitDecl, LinkageSpecDecl>(decl);
    if (!encloses && !InFiles(decl->getLocation())) return true;
    if (isa<EnumDecl, StaticAssertDecl, ParmVarDecl>(decl)) return true;
    if (const auto* variable = dyn_cast<VarDecl>(decl)) {
      if (variable->isConstexpr() || variable->hasGlobalStorage()) return true;
    }
    const auto* function = dyn_cast<FunctionDecl>(decl);
    if (function == nullptr) return Base::TraverseDecl(decl);
    if (function->isConsteval() || !function->doesThisDeclarationHaveABody()) return true;
    if (function->getReturnType()->isVoidType()) AddNeedlessReturns(function->getBody(), needless_);
    functions_.push_back(function->getQualifiedNameAsString());
    const bool going_on = Base::TraverseDecl(decl);
    functions_.pop_back();
    return going_on;
  }

  // What constant evaluation computes, and types.
  bool TraverseTypeLoc(TypeLoc) { return true; }
  bool TraverseTemplateArgumentLoc(const TemplateArgumentLoc&) { return true; }
  bool TraverseNestedNameSpecifierLoc(NestedNameSpecifierLoc) { return true; }

  bool TraverseStmt(Stmt* statement) {
    if (statement == nullptr) return true;
    if (isa<ConstantExpr, UnaryExprOrTypeTraitExpr, CXXNoexceptExpr, RequiresExpr>(statement)) return true;
    if (const auto* condition = dyn_cast<IfStmt>(statement); condition != nullptr && condition->isConstexpr()) {
      return TraverseStmt(const_cast<IfStmt*>(condition)->getThen()) &&
             TraverseStmt(const_cast<IfStmt*>(condition)->getElse());
    }
    if (const auto* call = dyn_cast<CallExpr>(statement)) {
      const std::string name = NameOf(*call);
      if (IsExcludedCall(name) || IsReport(name)) return true;
    }
    return Base::TraverseStmt(statement);
  }

  // The form with conversions: a number in braces has its member's type there.
  bool TraverseInitListExpr(InitListExpr* list) {
    InitListExpr* const semantic = list->isSemanticForm() ? list : list->getSemanticForm();
    return Base::TraverseSynOrSemInitListExpr(semantic == nullptr ? list : semantic, nullptr);
  }

  bool VisitBinaryOperator(BinaryOperator* op) {
    if (op->isLogicalOp()) {
      VisitLogical(*op);
      return true;
    }
    if (op->isComparisonOp()) {  // another enumerator says what the negated comparison says
      covered_.insert(op->getLHS()->IgnoreParenImpCasts());
      covered_.insert(op->getRHS()->IgnoreParenImpCasts());
    }
    const std::optional<Spelling> spelling = SpellingOf(op->getOpcode());
    if (!spelling || !IsPlain(op->getLHS()->getType()) || !IsPlain(op->getRHS()->getType())) return true;
    if (!op->isComparisonOp() && (IsPointer(op->getLHS()->getType()) || IsPointer(op->getRHS()->getType())))
      return true;
    const auto range = RangeOf(*op), left = RangeOf(*op->getLHS()), right = RangeOf(*op->getRHS());
    if (!range || !left || !right || op->getOperatorLoc().isMacroID()) return true;
    std::string ids = std::to_string(Add(*range, spelling->kind));
    if (spelling->negated != nullptr) ids += ", " + std::to_string(Add(*range, spelling->negated));
    Current().Wrap(range->begin, range->end, std::string("::plcxx::mutants::") + spelling->function + "(" + ids + ", ",
                   ")");
    const unsigned at = sources_.getFileOffset(op->getOperatorLoc());
    Current().Replace(at, at + Lexer::MeasureTokenLength(op->getOperatorLoc(), sources_, context_.getLangOpts()), ",");
    return true;
  }

  // Comparisons of classes.
  bool VisitCXXOperatorCallExpr(CXXOperatorCallExpr* call) {
    if (call->isComparisonOp() && call->getType()->isBooleanType()) Negate(*call, "comparison negated");
    return true;
  }
  bool VisitCXXRewrittenBinaryOperator(CXXRewrittenBinaryOperator* op) {
    Negate(*op, "comparison negated");
    return true;
  }

  bool VisitUnaryOperator(UnaryOperator* op) {
    if (op->getOpcode() == UO_LNot) Negate(*op, "! dropped");
    const bool negative = op->getOpcode() == UO_Minus;
    if ((negative || op->getOpcode() == UO_Not) && IsPlain(op->getType())) {
      const auto range = RangeOf(*op);
      if (!range || !RangeOf(*op->getSubExpr())) return true;
      const std::string id = std::to_string(Add(*range, negative ? "- dropped" : "~ dropped"));
      Current().Wrap(range->begin, range->end,
                     std::string("::plcxx::mutants::") + (negative ? "Negative(" : "Complement(") + id + ", ", ")");
      Current().Replace(range->begin, range->begin + 1, "");
    }
    return true;
  }

  bool VisitImplicitCastExpr(ImplicitCastExpr* cast) {
    const Expr* const number = cast->getSubExpr()->IgnoreParens();
    if (!isa<IntegerLiteral>(number)) return true;
    if (cast->getCastKind() == CK_NullToPointer || cast->getCastKind() == CK_IntegralToBoolean) {
      skipped_.insert(number);
    } else if (cast->getCastKind() == CK_IntegralCast || cast->getCastKind() == CK_IntegralToFloating) {
      types_[number] = cast->getType();
    }
    return true;
  }

  bool VisitIntegerLiteral(IntegerLiteral* number) {
    const auto range = RangeOf(*number);
    if (!range || skipped_.contains(number)) return true;
    const auto found = types_.find(number);
    const QualType type = (found == types_.end() ? number->getType() : found->second).getCanonicalType();
    if (!type->isBuiltinType()) return true;
    std::string ids = std::to_string(Add(*range, "number + 1"));
    if (number->getValue() != 0) ids += ", " + std::to_string(Add(*range, "number - 1"));
    Current().Wrap(range->begin, range->end,
                   "::plcxx::mutants::Number<" + type.getUnqualifiedType().getAsString(context_.getPrintingPolicy()) +
                       ">(" + ids + ", ",
                   ")");
    return true;
  }

  bool VisitCXXBoolLiteralExpr(CXXBoolLiteralExpr* literal) {
    Negate(*literal, "truth negated");
    return true;
  }

  // One of few: an edge, a direction, a mode.
  bool VisitDeclRefExpr(DeclRefExpr* reference) {
    const auto* enumerator = dyn_cast<EnumConstantDecl>(reference->getDecl());
    const auto range = RangeOf(*reference);
    if (enumerator == nullptr || !range || covered_.contains(reference)) return true;
    const auto* all = cast<EnumDecl>(enumerator->getDeclContext());
    const std::vector<const EnumConstantDecl*> values(all->enumerator_begin(), all->enumerator_end());
    if (values.size() < 2 || values.size() > 8) return true;
    const size_t index = std::ranges::find(values, enumerator) - values.begin();
    const std::string other = values[(index + 1) % values.size()]->getNameAsString();
    const std::string text = TextOf(*range);
    const size_t size = enumerator->getNameAsString().size();
    if (text.size() < size) return true;
    const unsigned id = Add(*range, "enumerator to " + other);
    Current().Wrap(
        range->begin, range->end,
        "(::plcxx::mutants::At(" + std::to_string(id) + ") ? " + text.substr(0, text.size() - size) + other + " : ",
        ")");
    return true;
  }

  bool VisitLambdaExpr(LambdaExpr* lambda) {
    if (lambda->getCallOperator()->getReturnType()->isVoidType()) AddNeedlessReturns(lambda->getBody(), needless_);
    return true;
  }
  bool VisitIfStmt(IfStmt* statement) {
    if (!statement->isConstexpr() && statement->getConditionVariable() == nullptr)
      NegateCondition(statement->getCond());
    OfferToDrop(statement->getThen());
    OfferToDrop(statement->getElse());
    return true;
  }
  bool VisitWhileStmt(WhileStmt* statement) {
    if (statement->getConditionVariable() == nullptr) NegateCondition(statement->getCond());
    VisitLoopBody(statement->getBody());
    return true;
  }
  bool VisitDoStmt(DoStmt* statement) {
    VisitLoopBody(statement->getBody());
    return true;
  }
  bool VisitForStmt(ForStmt* statement) {
    VisitLoopBody(statement->getBody());
    return true;
  }
  bool VisitCXXForRangeStmt(CXXForRangeStmt* statement) {
    VisitLoopBody(statement->getBody());
    return true;
  }
  bool VisitSwitchStmt(SwitchStmt* statement) {
    AddNeedlessBreaks(statement->getBody(), needless_);
    return true;
  }
  bool VisitSwitchCase(SwitchCase* statement) {
    OfferToDrop(statement->getSubStmt());
    return true;
  }
  bool VisitCompoundStmt(CompoundStmt* statement) {
    for (Stmt* const child : statement->body()) OfferToDrop(child);
    return true;
  }
  bool VisitConditionalOperator(ConditionalOperator* op) {
    NegateCondition(op->getCond());
    return true;
  }
  bool VisitReturnStmt(ReturnStmt* statement) {
    if (statement->getRetValue() != nullptr) NegateTruth(*statement->getRetValue(), "result negated");
    return true;
  }
  bool VisitVarDecl(VarDecl* variable) {
    if (variable->hasInit() && !variable->isCXXForRangeDecl() && variable->getType()->isBooleanType())
      NegateTruth(*variable->getInit(), "value negated");
    return true;
  }

  bool VisitCallExpr(CallExpr* call) {
    if (isa<CXXOperatorCallExpr>(call)) return true;
    const FunctionDecl* const callee = call->getDirectCallee();
    if (callee == nullptr) return true;
    const unsigned count = std::min(call->getNumArgs(), callee->getNumParams());
    for (unsigned i = 0; i + 1 < count; ++i) {
      if (SwapArguments(*call, *callee, i)) break;
    }
    return true;
  }

 private:
  bool InFiles(SourceLocation location) const {
    return location.isValid() && location.isFileID() && files_.contains(PathOf(location));
  }

  std::string PathOf(SourceLocation location) const {
    const auto file = sources_.getFileEntryRefForID(sources_.getFileID(location));
    return file ? file->getName().str() : "";
  }

  /// None: not in the files, or a macro wrote an end of it.
  std::optional<Range> RangeOf(SourceLocation begin, SourceLocation last) {
    if (!InFiles(begin) || last.isMacroID() || sources_.getFileID(begin) != sources_.getFileID(last))
      return std::nullopt;
    current_ = PathOf(begin);
    buffer_ = sources_.getBufferData(sources_.getFileID(begin)).str();
    const unsigned end =
        sources_.getFileOffset(last) + Lexer::MeasureTokenLength(last, sources_, context_.getLangOpts());
    const Range range{sources_.getFileOffset(begin), end};
    line_ = sources_.getSpellingLineNumber(begin);
    return range;
  }
  std::optional<Range> RangeOf(const Stmt& statement) {
    return RangeOf(statement.getBeginLoc(), statement.getEndLoc());
  }

  /// Of the file of the last range.
  Edits& Current() { return result_.files[current_]; }
  std::string TextOf(Range range) const { return buffer_.substr(range.begin, range.end - range.begin); }

  unsigned Add(Range range, std::string kind) {
    Mutant mutant{next_++, current_, line_, functions_.empty() ? "" : functions_.back(), std::move(kind), {}};
    for (const char c : TextOf(range)) {
      const bool space = c == ' ' || c == '\n' || c == '\t';
      if (!space || (!mutant.text.empty() && mutant.text.back() != ' ')) mutant.text += space ? ' ' : c;
    }
    result_.mutants.push_back(std::move(mutant));
    return result_.mutants.back().id;
  }

  static bool IsPointer(QualType type) { return type->isAnyPointerType() || type->isNullPtrType(); }

  static bool IsPlain(QualType type) {
    return type->isDependentType() || type->isArithmeticType() || type->isEnumeralType() || IsPointer(type);
  }

  static std::string NameOf(const CallExpr& call) {
    if (const auto* callee = dyn_cast_or_null<NamedDecl>(call.getCalleeDecl())) return callee->getNameAsString();
    return {};
  }

  /// a && b: (m ^ (a')) && (m ^ (b')) ^ m is a || b when m; a' is a, or true when its mutant is active.
  void VisitLogical(BinaryOperator& op) {
    if (op.getType()->isDependentType()) return;
    const auto range = RangeOf(op), left = RangeOf(*op.getLHS()), right = RangeOf(*op.getRHS());
    if (!range || !left || !right || op.getOperatorLoc().isMacroID()) return;
    const bool conjunction = op.getOpcode() == BO_LAnd;
    const std::string swapped = Point(Add(*range, conjunction ? "&& to ||" : "|| to &&"));
    Current().Wrap(range->begin, range->end, "((", ") != " + swapped + ")");
    const auto* chain = dyn_cast<BinaryOperator>(op.getLHS()->IgnoreParenImpCasts());
    const bool is_chain = chain != nullptr && chain->getOpcode() == op.getOpcode();
    for (const Range side : {*left, *right}) {
      std::string inner = "static_cast<bool>(";
      if (!is_chain || side.begin != left->begin) {
        const std::string dropped = Point(Add(side, conjunction ? "operand of && dropped" : "operand of || dropped"));
        inner = conjunction ? dropped + " || " + inner : "!" + dropped + " && " + inner;
      }
      Current().Wrap(side.begin, side.end, "(" + swapped + " != (" + inner, ")))");
    }
  }

  static std::string Point(unsigned id) { return "::plcxx::mutants::At(" + std::to_string(id) + ")"; }

  void Negate(const Expr& expression, const char* kind) {
    if (covered_.contains(&expression) || expression.isTypeDependent()) return;
    const auto range = RangeOf(expression);
    if (!range || !seen_.emplace(current_, range->begin, range->end).second) return;
    Current().Wrap(range->begin, range->end, "(" + Point(Add(*range, kind)) + " != static_cast<bool>(", "))");
  }

  /// Has mutants of its own that say the same as its negation.
  static bool IsCovered(const Expr& expression) {
    const Expr* const inner = expression.IgnoreParenImpCasts();
    if (const auto* op = dyn_cast<BinaryOperator>(inner)) return op->isComparisonOp() || op->isLogicalOp();
    if (const auto* op = dyn_cast<UnaryOperator>(inner)) return op->getOpcode() == UO_LNot;
    if (const auto* call = dyn_cast<CXXOperatorCallExpr>(inner)) return call->isComparisonOp();
    if (const auto* choice = dyn_cast<ConditionalOperator>(inner)) return choice->getType()->isBooleanType();
    return isa<CXXRewrittenBinaryOperator, CXXBoolLiteralExpr>(inner);
  }

  void NegateCondition(const Expr* condition) {
    if (condition != nullptr && !IsCovered(*condition)) Negate(*condition, "condition negated");
  }
  void NegateTruth(const Expr& value, const char* kind) {
    if (value.getType()->isBooleanType() && !IsCovered(value)) Negate(value, kind);
  }

  void VisitLoopBody(Stmt* body) {
    AddNeedlessContinues(body, needless_);
    OfferToDrop(body);
  }

  void OfferToDrop(Stmt* statement) {
    if (statement == nullptr || needless_.contains(statement)) return;
    if (const auto* expression = dyn_cast<Expr>(statement)) {
      DropExpression(*expression);
    } else if (isa<ContinueStmt, BreakStmt>(statement) ||
               (isa<ReturnStmt>(statement) && cast<ReturnStmt>(statement)->getRetValue() == nullptr)) {
      DropJump(*statement);
    }
  }

  void DropExpression(const Expr& expression) {
    const Expr* const inner = expression.IgnoreImplicit();
    if (const auto* call = dyn_cast<CallExpr>(inner); call != nullptr && IsExcludedCall(NameOf(*call))) return;
    const auto range = RangeOf(expression);
    if (!range) return;
    const std::string dropped = Point(Add(*range, "statement dropped")) + " ? void() : void(";
    const auto* op = dyn_cast<BinaryOperator>(inner);
    const bool is_list = op != nullptr && op->isCommaOp();
    Current().Wrap(range->begin, range->end, dropped + (is_list ? "(" : ""), is_list ? "))" : ")");
  }

  void DropJump(const Stmt& statement) {
    const auto range = RangeOf(statement);
    if (!range || range->end >= buffer_.size() || buffer_[range->end] != ';') return;
    Current().Wrap(range->begin, range->end + 1, "{ if (!" + Point(Add(*range, "statement dropped")) + ") ", " }");
  }

  /// Nothing in it is a mutant, and evaluating it twice or not at all is the same.
  static bool IsSimple(const Expr& expression) {
    const Expr* const inner = expression.IgnoreParenImpCasts();
    if (const auto* reference = dyn_cast<DeclRefExpr>(inner)) return !isa<EnumConstantDecl>(reference->getDecl());
    if (isa<CXXThisExpr>(inner)) return true;
    if (const auto* member = dyn_cast<MemberExpr>(inner)) return IsSimple(*member->getBase());
    if (const auto* op = dyn_cast<UnaryOperator>(inner))
      return op->getOpcode() == UO_Deref && IsSimple(*op->getSubExpr());
    if (const auto* construct = dyn_cast<CXXConstructExpr>(inner)) {
      return construct->getNumArgs() == 1 && construct->getConstructor()->isCopyOrMoveConstructor() &&
             IsSimple(*construct->getArg(0));
    }
    return false;
  }

  bool SwapArguments(const CallExpr& call, const FunctionDecl& callee, unsigned i) {
    const Expr &first = *call.getArg(i), &second = *call.getArg(i + 1);
    const auto bare = [](QualType type) { return type.getNonReferenceType().getCanonicalType().getUnqualifiedType(); };
    if (TakesEitherOrder(callee)) return false;
    if (first.isTypeDependent() || second.isTypeDependent() || !IsSimple(first) || !IsSimple(second)) return false;
    if (first.getType().getCanonicalType() != second.getType().getCanonicalType()) return false;
    if (callee.getParamDecl(i)->getType().getCanonicalType() !=
        callee.getParamDecl(i + 1)->getType().getCanonicalType())
      return false;
    if (bare(first.getType()) != bare(callee.getParamDecl(i)->getType())) return false;
    const auto a = RangeOf(first), b = RangeOf(second);
    if (!a || !b) return false;
    const std::string left = TextOf(*a), right = TextOf(*b);
    if (left == right) return false;
    const std::string point = Point(Add({a->begin, b->end}, "arguments swapped"));
    Current().Wrap(a->begin, a->end, "(" + point + " ? " + right + " : ", ")");
    Current().Wrap(b->begin, b->end, "(" + point + " ? " + left + " : ", ")");
    return true;
  }

  ASTContext& context_;
  const SourceManager& sources_;
  const std::set<std::string> files_;
  unsigned next_;
  Rewritten result_;
  std::vector<std::string> functions_;
  std::string current_, buffer_;  // file of the last range
  unsigned line_ = 0;
  Jumps needless_;
  std::set<const Expr*> covered_;                               // enumerators: a mutant around them says the same
  std::set<const Expr*> skipped_;                               // numbers that are none: null pointers, truths
  std::map<const Expr*, QualType> types_;                       // what a number is converted to
  std::set<std::tuple<std::string, unsigned, unsigned>> seen_;  // negated
};

}  // namespace

Rewritten FindSites(ASTContext& context, const std::vector<std::string>& files, unsigned first) {
  Finder finder(context, files, first);
  finder.TraverseDecl(context.getTranslationUnitDecl());
  return finder.Take();
}

}  // namespace plcxx::mutants
