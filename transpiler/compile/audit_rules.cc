#include "transpiler/compile/audit_rules.h"

#include <algorithm>
#include <functional>

namespace plcxx::compile {
namespace {

struct RoutineRow {
  std::string_view name;
  RoutineUse use;
};
constexpr RoutineRow kRoutines[] = {
#define PLCXX_ROUTINE(Name, Use) {Name, RoutineUse::Use},
#include "transpiler/compile/support_routines.def"
#undef PLCXX_ROUTINE
};

class Auditor {
 public:
  Auditor(const ProgramCode& code, const AuditExpectations& expectations) : code_(code), expectations_(expectations) {}

  std::vector<AuditFinding> Run() {
    reached_.assign(code_.function_count(), true);
    for (uint32_t id = 0; id < code_.function_count(); ++id) CheckFunction(id);
    for (const ObjectFacts& object : code_.objects()) {
      for (const CodeSection& section : object.sections) CheckSection(section);
      for (const SymbolUse& use : object.uses) CheckUse(object, use);
    }
    FindCircles();
    return std::move(findings_);
  }

  std::optional<std::vector<AuditFinding>> RunFrom(std::string_view entry) {
    reached_.assign(code_.function_count(), false);
    std::vector<uint32_t> open;
    for (uint32_t id = 0; id < code_.function_count(); ++id) {
      if (code_.Text(id).find(entry) == std::string::npos) continue;
      reached_[id] = true;
      open.push_back(id);
    }
    if (open.empty()) return std::nullopt;
    while (!open.empty()) {
      const uint32_t id = open.back();
      open.pop_back();
      CheckFunction(id);
      for (const CodeBlock& block : code_.Function(id).blocks) {
        for (const CodeCall& call : block.calls) {
          const uint32_t callee = code_.Callee(id, call);
          if (callee == kNoFunction) {
            CheckSymbol(code_.Name(id), code_.Symbol(id, call));
          } else if (!reached_[callee]) {
            reached_[callee] = true;
            open.push_back(callee);
          }
        }
      }
    }
    FindCircles();
    return std::move(findings_);
  }

 private:
  void Add(AuditRule rule, std::string function, std::string detail) {
    const auto same = [&](const AuditFinding& other) {
      return other.rule == rule && other.function == function && other.detail == detail;
    };
    if (std::ranges::none_of(findings_, same)) findings_.push_back({rule, std::move(function), std::move(detail)});
  }

  void CheckFunction(uint32_t id) {
    const CodeFunction& function = code_.Function(id);
    if (!function.decoded) Add(AuditRule::kUnreadable, code_.Name(id), "");
    if (function.indirect_calls + function.indirect_jumps > 0) Add(AuditRule::kIndirectCall, code_.Name(id), "");
  }

  void CheckSection(const CodeSection& section) {
    switch (section.kind) {
      case SectionKind::kConstructors:
        return Add(AuditRule::kStaticConstructor, section.name, "");
      case SectionKind::kUnwinding:
        return Add(AuditRule::kException, section.name, "unwind tables");
      case SectionKind::kCode:
      case SectionKind::kConstants:
      case SectionKind::kData:
      case SectionKind::kZeroes:
      case SectionKind::kOther:
        return;
    }
  }

  void CheckUse(const ObjectFacts& object, const SymbolUse& use) {
    const CodeSymbol& symbol = object.symbols[use.symbol];
    if (!code_.Defines(symbol.name)) CheckSymbol(NameOf(use.user), symbol);
  }

  /// One that no object defines.
  void CheckSymbol(const std::string& user, const CodeSymbol& symbol) {
    switch (UseOfSymbol(symbol.name)) {
      case RoutineUse::kMemory:
      case RoutineUse::kInteger:
        return;
      case RoutineUse::kFloat:
        if (!expectations_.has_floats) Add(AuditRule::kFloat, user, symbol.text);
        return;
      case RoutineUse::kHeap:
        return Add(AuditRule::kHeap, user, symbol.text);
      case RoutineUse::kException:
        return Add(AuditRule::kException, user, symbol.text);
      case RoutineUse::kUnknown:
        if (!expectations_.host_functions.contains(NameOf(symbol.text))) Add(AuditRule::kUndefined, user, symbol.text);
        return;
    }
  }

  /// Each circle of calls once, told at the function that is met first.
  void FindCircles() {
    enum class Mark : uint8_t { kNew, kOpen, kDone };
    std::vector<Mark> marks(code_.function_count(), Mark::kNew);
    std::vector<uint32_t> path;
    const std::function<void(uint32_t)> visit = [&](uint32_t id) {
      marks[id] = Mark::kOpen;
      path.push_back(id);
      for (const CodeBlock& block : code_.Function(id).blocks) {
        for (const CodeCall& call : block.calls) {
          const uint32_t callee = code_.Callee(id, call);
          if (callee == kNoFunction || marks[callee] == Mark::kDone) continue;
          if (marks[callee] == Mark::kNew) {
            visit(callee);
            continue;
          }
          std::string circle;
          for (auto at = std::ranges::find(path, callee); at != path.end(); ++at) circle += code_.Name(*at) + ", ";
          Add(AuditRule::kRecursion, code_.Name(callee), circle + code_.Name(callee));
        }
      }
      path.pop_back();
      marks[id] = Mark::kDone;
    };
    for (uint32_t id = 0; id < code_.function_count(); ++id) {
      if (reached_[id] && marks[id] == Mark::kNew) visit(id);
    }
  }

  const ProgramCode& code_;
  const AuditExpectations& expectations_;
  std::vector<bool> reached_;  // by function: it is looked at
  std::vector<AuditFinding> findings_;
};

}  // namespace

RoutineUse UseOfSymbol(std::string_view name) {
  for (const RoutineRow& row : kRoutines) {
    const bool family = row.name.ends_with('*');
    if (family ? name.starts_with(row.name.substr(0, row.name.size() - 1)) : name == row.name) return row.use;
  }
  return RoutineUse::kUnknown;
}

std::vector<AuditFinding> Audit(const ProgramCode& code, const AuditExpectations& expectations) {
  return Auditor(code, expectations).Run();
}

std::optional<std::vector<AuditFinding>> AuditFrom(const ProgramCode& code, std::string_view entry,
                                                   const AuditExpectations& expectations) {
  return Auditor(code, expectations).RunFrom(entry);
}

}  // namespace plcxx::compile
