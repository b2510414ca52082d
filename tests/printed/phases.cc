#include "tests/printed/phases.h"

#include <array>
#include <functional>
#include <memory>
#include <sstream>
#include <utility>

#include "tests/printed/groups.h"
#include "transpiler/dialects/references.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/reader.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/structure.h"

namespace plcxx::printed {
namespace {

using compilation::CompilationRequest;
using compilation::Stage;

/// The same in every program: groups of two programs are compared by their headings.
constexpr std::string_view kName = "p";

compilation::Compilation CompiledTo(const Input& input, Stage stage, ir::Facts facts = ir::Facts::kTrusted) {
  CompilationRequest request = input.request;
  request.name = kName;
  if (facts == ir::Facts::kChecked) request.options.emplace_back(compilation::kFactsOption, "checked");
  if (input.ir.empty()) return compilation::Compile(request, stage);
  compilation::Compilation compiled;
  compiled.sources = std::make_unique<source::SourceManager>();
  compiled.program = ir::ReadOrDie(input.ir);
  passes::Structure(compiled.program);
  passes::NestBlocks(compiled.program);  // and nothing is folded: the emitter is to see it as it is written
  return compiled;
}

std::string IrOf(const Input& input) { return ir::Print(CompiledTo(input, Stage::kLowered).program); }

std::string CheckedOf(const Input& input) {
  return ir::Print(CompiledTo(input, Stage::kLowered, ir::Facts::kChecked).program);
}

/// Of a program that is ready to be emitted.
std::string OfOptimized(const Input& input, const std::function<std::string(const compilation::Compilation&)>& print) {
  if (input.optimized == nullptr)
    input.optimized = std::make_shared<compilation::Compilation>(CompiledTo(input, Stage::kOptimized));
  return input.optimized->ok() ? print(*input.optimized) : "the program has errors\n";
}

emit::Emittable Legalized(const compilation::Compilation& compiled, emit::EmitOptions options) {
  options.name = kName;
  return emit::legalize::Legalize(compiled.program, options);
}

std::string FilesOf(const compilation::Compilation& compiled, emit::EmitOptions options) {
  std::string text;
  for (const emit::OutputFile& file :
       emit::print::PrintCpp(Legalized(compiled, std::move(options)), *compiled.sources)) {
    text += file.text;
  }
  return text;
}

std::string EmittableOf(const Input& input) {
  return OfOptimized(input, [](auto& compiled) { return emit::print::PrintEmittable(Legalized(compiled, {})); });
}

std::string CppOf(const Input& input) {
  return OfOptimized(input, [](auto& compiled) { return FilesOf(compiled, {}); });
}

std::string DebugOf(const Input& input) {
  return OfOptimized(input, [](auto& compiled) { return FilesOf(compiled, {.flavour = emit::Flavour::kDebug}); });
}

/// Each #line directive and the line that it is for.
std::string DirectivesOf(const Input& input) {
  return OfOptimized(input, [](auto& compiled) {
    std::string text;
    bool after = false;
    std::istringstream in(FilesOf(compiled, {.line_directives = true}));
    for (std::string line; std::getline(in, line);) {
      const bool directive = line.starts_with("#line");
      if (directive || after) text += line + '\n';
      after = directive;
    }
    return text;
  });
}

/// Which functions there are: of a long program, whose texts are those of short ones.
std::string HeadingsOf(const Input& input) { return Headings(CppOf(input)); }

/// Which functions are in which of three files.
std::string PartsOf(const Input& input) {
  return OfOptimized(input, [](auto& compiled) {
    std::string text;
    for (const emit::OutputFile& file : emit::print::PrintCpp(Legalized(compiled, {.parts = 3}), *compiled.sources))
      text += file.name + ":\n" + Headings(file.text);
    return text;
  });
}

std::string MapOf(const Input& input) {
  return OfOptimized(input,
                     [](auto& compiled) { return emit::print::PrintMap(Legalized(compiled, {}), *compiled.sources); });
}

/// "12:3 hnc-W18 what was found": of each message.
std::string MessagesIn(const compilation::Compilation& compiled) {
  std::string text;
  for (const diag::Diagnostic& diagnostic : compiled.diagnostics.all()) {
    const source::Position at = compiled.sources->Locate(diagnostic.range.begin);
    text += std::to_string(at.line) + ':' + std::to_string(at.column) + ' ' + std::string(diagnostic.row->code) + ' ' +
            diagnostic.text + '\n';
  }
  return text;
}

std::string MessagesOf(const Input& input) { return MessagesIn(CompiledTo(input, Stage::kChecked)); }

/// Where the sources' variables and functions are in the program.
std::string ReferenceOf(const Input& input) {
  compilation::Compilation compiled = CompiledTo(input, Stage::kLowered);
  const dialects::MakeReference make = compiled.dialect == nullptr ? nullptr : dialects::ReferenceOf(*compiled.dialect);
  if (make == nullptr || !compiled.ok()) return "none\n";
  dialects::Request request = compiled.MakeRequest();
  const ir::Reference reference = make(request);
  const auto bytes = [&](const ir::ReferenceBytes& at) {
    return ' ' + compiled.program.spaces[at.space].name + '[' + std::to_string(at.offset) + "] " +
           std::to_string(at.bytes);
  };
  const auto host = [&](ir::HostFunctionId id) {
    return id.valid() ? " host " + compiled.program.host_functions[id].name : std::string();
  };
  const auto routine = [&](ir::RoutineId id) {
    return id.valid() ? " routine " + compiled.program.routines[id].name : std::string();
  };
  std::string text;
  for (const ir::ReferenceVariable& variable : reference.variables) {
    text += "variable " + variable.name + bytes(variable.at) + (variable.is_constant ? " constant" : "") +
            (variable.is_table ? " table" : "") + '\n';
  }
  for (const ir::ReferenceFunction& function : reference.functions) {
    text += "function " + function.name + routine(function.routine) +
            (function.result ? " gives" + bytes(*function.result) : "") +
            (function.in_callers.empty() ? "" : " in callers: " + function.in_callers) + '\n';
    for (const ir::ReferenceLocal& local : function.locals)
      text += "  " + local.name + bytes(local.at) + (local.is_parameter ? " parameter" : "") + '\n';
  }
  for (const ir::ReferenceCallee& callee : reference.callees)
    text += "callee " + callee.name + routine(callee.routine) + host(callee.host) + '\n';
  for (const ir::ReferenceEffect& effect : reference.effects) {
    text += "effect " + effect.function;
    for (const std::string& argument : effect.arguments) text += ' ' + argument;
    if (effect.stores_at) text += " stores" + bytes(*effect.stores_at);
    text +=
        " mask " + std::to_string(effect.mask) + " value " + std::to_string(effect.value) + host(effect.host) + '\n';
  }
  return text + "fault" + routine(reference.fault) + '\n';
}

/// Which line of the sources each instruction is for: what reports and messages say.
std::string LinesOf(const Input& input) {
  const compilation::Compilation compiled = CompiledTo(input, Stage::kLowered);
  const ir::Program& program = compiled.program;
  std::string text;
  for (const ir::Routine& routine : program.routines) {
    text += "routine " + routine.name + " {";
    uint32_t line = 0;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (!region.valid()) continue;
      ir::ForEachInst(program, region, [&](ir::InstId id) {
        const ir::Inst& inst = program[id];
        if (inst.range == source::Range()) return;
        const source::Position at = compiled.sources->Locate(inst.range.begin);
        if (at.line != line) text += "\n  " + std::to_string(line = at.line) + ':';
        text += ' ' + std::string(ir::Info(inst.op).text);
      });
    }
    text += "\n}\n";
  }
  return text;
}

constexpr std::array kPhases = {
    Phase{"messages", MessagesOf, ""},
    Phase{"ir", IrOf, ""},
    Phase{"checked", CheckedOf, "ir"},
    Phase{"emittable", EmittableOf, ""},
    Phase{"cpp", CppOf, ""},
    Phase{"debug", DebugOf, "cpp"},
    Phase{"parts", PartsOf, ""},
    Phase{"map", MapOf, ""},
    Phase{"directives", DirectivesOf, ""},
    Phase{"lines", LinesOf, ""},
    Phase{"headings", HeadingsOf, ""},
    Phase{"reference", ReferenceOf, ""},
};

}  // namespace

std::string SaidOf(const Input& input) {
  const compilation::Compilation compiled = CompiledTo(input, Stage::kChecked);
  return MessagesIn(compiled) + (compiled.ok() ? ir::Print(compiled.program) : "");
}

std::span<const Phase> Phases() { return kPhases; }

}  // namespace plcxx::printed
