// plcxx verify: the compiled code of this very program, proved equal to what the program means.
#include <sys/resource.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/dialects/references.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/jobs.h"
#include "transpiler/driver/named_file.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/prove/verify/bitcode.h"
#include "transpiler/prove/verify/front_end/front_end.h"
#include "transpiler/prove/verify/object_code.h"
#include "transpiler/prove/verify/verify.h"
#include "transpiler/review/verify/certificate.h"
#include "transpiler/review/verify/facts.h"
#include "transpiler/scenarios/failure.h"
#include "transpiler/support/beside_work.h"
#include "transpiler/support/counted.h"
#include "transpiler/support/hex.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

constexpr const char* kVerifyFooter = R"(Examples:
  plcxx verify turret.sym turret.plc
  plcxx verify mill.cld --certificate mill.verified.json
  plcxx verify turret.plc -O s --time 5min
  plcxx verify turret.plc --target cortex-m4 -O s
  plcxx verify turret.plc --target cortex-m4 --object out/libturret.a

The program is emitted and compiled by Clang to LLVM's instructions. Each function is executed on symbols, once as the
program means it and once as it was compiled, and both are proved equal for every state and every input: all of State,
the result, and what host functions are told. Callees come first; one that is proved is not looked into again. Functions
are compiled as such: what the compiler puts into one another in plcxx build is not looked at. With --object nothing is
compiled: the instructions of that object or library are what is proved, for cortex-m4 and rv32imac.
Of C (dialect hnc) Clang's own compilation of the sources is proved equal, too, function by function, for executions
without a run-time fault: --front-end=only does nothing else, --front-end=off leaves it out, and so does --routine.
What is decided is printed when it and all before it are, the verdict last; whatever --jobs is, the same.
What is told of a routine that is not: the first values that differ, and a state before it that shows it.
Then the facts that plcxx has decided from, ranges and bounds that test --checked executes: each is proved for every
state, or listed with its statement; one that does not hold with a state from which the simulator shows it.

What a verdict claims:
  proved         these functions, compiled so, do what the program means, for every state and every input
  different      from the state that is shown they do not
  not decided    nothing, and it is no success: more --time, or plcxx test, which executes the function
It does not claim that the program does what the machine needs (plcxx test, prove), that another compiler or other flags
give the same, that there is time and stack enough (plcxx build), or that host functions, linker and processor are right.
Assumed is what the certificate lists.
Exit codes: 0 all proved, 1 errors, a difference or something not decided, 2 wrong use, 3 a fault of plcxx.)";

struct VerifySettings {
  CommonOptions common;
  std::string name;
  std::string compiler = prove::verify::kVerifyCompiler;
  std::string level = "2";
  std::string target = "host";
  std::vector<std::string> objects;
  std::string certificate;
  std::vector<std::string> routines;
  std::string time = "60s";
  unsigned jobs = 0;
  std::string front_end = "on";
  bool quiet = false;
};

std::string Hex(uint64_t value) {
  if (value < 10) return std::to_string(value);
  return "0x" + support::HexDigits(value, 1, support::HexLetters::kCapital);
}

std::string DifferenceText(const prove::verify::CodeDifference& difference) {
  if (!difference.has_values) return "    " + difference.what + "\n";
  std::string text = "    " + difference.what + ": " + Hex(difference.expected) + " by the program, " +
                     Hex(difference.compiled) + " as compiled, with";
  if (difference.state.empty()) text += " all 0";
  for (size_t i = 0; i < difference.state.size(); ++i)
    text += (i == 0 ? " " : ", ") + difference.state[i].name + "=" + Hex(difference.state[i].value);
  return text + "\n";
}

/// The statement of the loop that the reason is about.
std::string LoopText(const prove::verify::RoutineProof& proof, const compilation::Compilation& compilation) {
  if (!proof.statement.valid()) return {};
  return "    the loop belongs to " +
         scenarios::StatementPlace(proof.statement, compilation.program, *compilation.sources) + "\n";
}

std::string ProofText(const prove::verify::RoutineProof& proof, const compilation::Compilation& compilation) {
  std::string text = "  " + proof.routine + ": ";
  switch (proof.result) {
    case prove::verify::ProofResult::kProved:
      text += "proved (" + support::Counted(proof.bytes, "byte") + " of State, " +
              support::Counted(proof.host_functions, "host function") + ", " +
              support::Counted(proof.instructions, "instruction");
      if (proof.claims != 0) text += "; " + support::Counted(proof.claims, "claim") + " of loops";
      if (!proof.relies_on.empty()) text += "; with " + support::Counted(proof.relies_on.size(), "proved function");
      return text + ")\n";
    case prove::verify::ProofResult::kNotDecided:
      text += "not decided: " + proof.reason + "\n" + LoopText(proof, compilation);
      for (const prove::verify::CodeDifference& difference : proof.differences) text += DifferenceText(difference);
      return text;
    case prove::verify::ProofResult::kDifferent:
      break;
  }
  text += "different\n";
  for (const prove::verify::CodeDifference& difference : proof.differences) text += DifferenceText(difference);
  return text;
}

std::string FrontEndText(const prove::verify::front_end::FunctionProof& function,
                         const compilation::Compilation& compilation) {
  std::string text = "  " + function.proof.routine + ", front end: ";
  if (!function.not_compared.empty()) return text + "not compared: " + function.not_compared + "\n";
  switch (function.proof.result) {
    case prove::verify::ProofResult::kProved:
      if (function.in_callers.empty()) return text + "proved equal to Clang's own compilation\n";
      text += "proved where it is called, in ";
      for (const std::string& caller : function.in_callers)
        text += (caller == function.in_callers.front() ? "" : ", ") + caller;
      return text + "\n";
    case prove::verify::ProofResult::kNotDecided:
      return text + "not decided: " + function.proof.reason + "\n" + LoopText(function.proof, compilation);
    case prove::verify::ProofResult::kDifferent:
      break;
  }
  text += "different\n";
  for (const prove::verify::CodeDifference& difference : function.proof.differences) text += DifferenceText(difference);
  return text;
}

/// One verification: from a compiled program to the certificate.
class Verification {
 public:
  /// `objects`: what the files of --object contain.
  Verification(const VerifySettings& settings, const compilation::CompilationRequest& request,
               const compile::Target& target, uint64_t routine_ms, std::vector<std::string> objects,
               compilation::Compilation& compilation, ProgressLine& progress)
      : settings_(settings),
        request_(request),
        target_(target),
        routine_ms_(routine_ms),
        compilation_(compilation),
        progress_(progress),
        objects_(std::move(objects)) {}

  /// Whether all is proved. What is decided is printed when it is; `said` is all of it.
  bool Run();
  const std::string& said() const { return said_; }
  /// The whole, in one line.
  const std::string& verdict() const { return verdict_; }
  /// It is not verified because of what the command line says.
  bool is_wrong_use() const { return wrong_use_; }

 private:
  void Say(const std::string& text);
  prove::verify::VerifyLimits MakeLimits();
  bool FindCompiler();
  bool Refuse(const std::string& reason);
  /// Those that were asked for, all when none was; false when the program has no such routine.
  bool ChooseRoutines();
  bool RunFrontEndAlone();
  /// Where the language has another compiler; whether nothing differs.
  bool CompareFrontEnd(const emit::Emittable& emittable, const prove::verify::VerifyLimits& limits);
  /// What Clang makes of the generated code, or the objects that were given; none: it was refused.
  std::unique_ptr<prove::verify::CompiledCode> FindCode(const emit::Emittable& emittable);
  std::unique_ptr<prove::verify::CompiledCode> CompileCode();
  std::unique_ptr<prove::verify::CompiledCode> ReadObjects(const emit::Emittable& emittable);
  bool WriteCertificate();

  const VerifySettings& settings_;
  const compilation::CompilationRequest& request_;
  const compile::Target& target_;
  uint64_t routine_ms_;
  compilation::Compilation& compilation_;
  ProgressLine& progress_;
  compile::Toolchain toolchain_;
  std::vector<emit::OutputFile> files_;
  prove::verify::Bitcode bitcode_;
  std::vector<std::string> objects_;  // contents
  std::vector<ir::RoutineId> routines_;
  std::vector<std::string> left_out_;
  std::vector<prove::verify::RoutineProof> proofs_;
  review::verify::FactsReport facts_;
  std::optional<prove::verify::front_end::Comparison> front_end_;
  std::string said_, verdict_;
  bool wrong_use_ = false;
};

void Verification::Say(const std::string& text) {
  said_ += text;
  if (settings_.quiet) return;
  progress_.Clear();
  std::cerr << text << std::flush;
}

bool Verification::Refuse(const std::string& reason) {
  verdict_ = compilation_.name + ": not verified: " + reason + "\n";
  return false;
}

/// Each has a deep stack, and a solver of its own, in which the process ends where there is no memory: where the
/// address space is limited, one at a time if nothing else was asked for.
unsigned JobsWithin(unsigned asked) {
  rlimit space{};
  const bool is_limited = getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
  return asked == 0 && is_limited ? 1 : JobsOf(asked);
}

prove::verify::VerifyLimits Verification::MakeLimits() {
  prove::verify::VerifyLimits limits;
  limits.routine_ms = routine_ms_;
  limits.jobs = JobsWithin(settings_.jobs);
  limits.progress = [this](const std::string& text) { progress_.Show(text); };
  return limits;
}

bool Verification::FindCompiler() {
  // Nothing is linked: of a target no tools are needed, only what Clang knows of it.
  auto found = compile::FindToolchain(compile::Targets().front(), settings_.compiler);
  if (const auto* missing = std::get_if<compile::MissingTool>(&found)) {
    compilation_.diagnostics.Report({}, diag::NoCompiler, missing->command, missing->package);
    return false;
  }
  toolchain_ = std::get<compile::Toolchain>(found);
  return toolchain_.is_clang || Refuse("'" + settings_.compiler + "' is no Clang");
}

bool Verification::ChooseRoutines() {
  std::vector<std::string> names;
  for (const ir::RoutineId id : prove::verify::RoutinesToVerify(compilation_.program)) {
    names.push_back(compilation_.program.routines[id].name);
    const bool chosen =
        settings_.routines.empty() || std::ranges::find(settings_.routines, names.back()) != settings_.routines.end();
    if (chosen) {
      routines_.push_back(id);
    } else {
      left_out_.push_back(names.back());
    }
  }
  for (const std::string& asked : settings_.routines) {
    if (std::ranges::find(names, asked) == names.end()) {
      wrong_use_ = true;
      return Refuse("there is no routine '" + asked + "'" + support::ThereAre(asked, names));
    }
  }
  return true;
}

bool Verification::WriteCertificate() {
  std::vector<std::pair<std::string, std::string>> objects;
  for (size_t i = 0; i < objects_.size(); ++i) objects.emplace_back(settings_.objects[i], objects_[i]);
  OutputRequest output;
  output.files.push_back(
      {settings_.certificate, review::verify::CertificateText({.compilation = &compilation_,
                                                               .files = &files_,
                                                               .toolchain = &toolchain_,
                                                               .target = &target_,
                                                               .bitcode = &bitcode_,
                                                               .objects = std::move(objects),
                                                               .proofs = &proofs_,
                                                               .facts = &facts_,
                                                               .left_out = left_out_,
                                                               .front_end = front_end_ ? &*front_end_ : nullptr})});
  output.protected_paths = PathsRead(compilation_, settings_.common);
  output.named = {settings_.certificate};
  const auto failure = WriteWithFolders(output);
  if (failure) ReportCannotWrite(*failure, compilation_);
  return !failure;
}

bool Verification::CompareFrontEnd(const emit::Emittable& emittable, const prove::verify::VerifyLimits& limits) {
  const dialects::MakeReference reference = dialects::ReferenceOf(*compilation_.dialect);
  if (reference == nullptr || settings_.front_end == "off") return true;
  if (!settings_.routines.empty()) {
    Say("  front end: left out\n");
    return true;
  }
  progress_.Show("compiling the sources");
  dialects::Request request = compilation_.MakeRequest();
  std::set<std::string> said;
  prove::verify::VerifyLimits saying = limits;
  saying.is_decided = [&](const prove::verify::RoutineProof& proof) {
    said.insert(proof.routine);
    Say(FrontEndText({.proof = proof, .not_compared = {}, .in_callers = {}}, compilation_));
  };
  front_end_ = prove::verify::front_end::Compare(emittable, reference(request), saying);
  if (!front_end_->reason.empty()) Say("  front end: not compared: " + front_end_->reason + "\n");
  bool same = true;
  for (const prove::verify::front_end::FunctionProof& function : front_end_->functions) {
    if (!said.contains(function.proof.routine)) Say(FrontEndText(function, compilation_));
    same = same && function.proof.result != prove::verify::ProofResult::kDifferent;
  }
  return same;
}

bool Verification::RunFrontEndAlone() {
  const prove::verify::VerifyLimits limits = MakeLimits();
  const emit::Emittable emittable = emit::legalize::Legalize(compilation_.program, {.name = compilation_.name});
  const bool same = CompareFrontEnd(emittable, limits);
  verdict_ = compilation_.name + ": " + (same ? "nothing is different\n" : "different\n");
  return same;
}

std::unique_ptr<prove::verify::CompiledCode> Verification::CompileCode() {
  progress_.Show("compiling");
  auto compiled = prove::verify::CompileToBitcode({.toolchain = &toolchain_,
                                                   .target = &target_,
                                                   .level = settings_.level,
                                                   .files = &files_,
                                                   .further_flags = {},
                                                   .runtime = {}});
  if (const auto* failure = std::get_if<prove::verify::BitcodeFailure>(&compiled)) {
    std::cerr << failure->output;
    Refuse(failure->message);
    return nullptr;
  }
  bitcode_ = std::move(std::get<prove::verify::Bitcode>(compiled));
  prove::verify::LoadedCode loaded = prove::verify::LoadCode(bitcode_.files);
  if (loaded.code == nullptr) Refuse(loaded.reason);
  return std::move(loaded.code);
}

std::unique_ptr<prove::verify::CompiledCode> Verification::ReadObjects(const emit::Emittable& emittable) {
  progress_.Show("reading objects");
  const std::vector<prove::verify::Signature> signatures = prove::verify::SignaturesOf(emittable);
  prove::verify::LoadedCode loaded = prove::verify::LoadObjectCode(
      {.objects = objects_, .signatures = signatures, .processor = std::string(target_.processor)});
  if (loaded.code == nullptr) Refuse(loaded.reason);
  return std::move(loaded.code);
}

std::unique_ptr<prove::verify::CompiledCode> Verification::FindCode(const emit::Emittable& emittable) {
  if (!settings_.objects.empty()) return ReadObjects(emittable);
  return FindCompiler() ? CompileCode() : nullptr;
}

bool Verification::Run() {
  if (!compilation_.has_program) return Refuse("the sources are data only");
  if (settings_.front_end == "only") return RunFrontEndAlone();
  if (!ChooseRoutines()) return false;
  progress_.Show("printing C++");
  const emit::Emittable emittable = emit::legalize::Legalize(compilation_.program, {.name = compilation_.name});
  files_ = emit::print::PrintCpp(emittable, *compilation_.sources);
  const std::unique_ptr<prove::verify::CompiledCode> code = FindCode(emittable);
  if (code == nullptr) return false;
  const prove::verify::VerifyLimits limits = MakeLimits();
  // What the facts' proofs ask for, nobody else finds: they are made beside the others, and told after them.
  const compilation::Compilation checked = review::verify::CompileChecked(request_);
  support::BesideWork facts_beside(support::kDeepStackBytes, [&] {
    facts_ = review::verify::VerifyFactsOf(
        checked, settings_.routines, {.question_ms = limits.question_ms, .routine_ms = routine_ms_, .progress = {}});
  });
  bool all = true;
  std::string causes;
  prove::verify::VerifyLimits saying = limits;
  saying.is_decided = [&](const prove::verify::RoutineProof& proof) {
    const bool proved = proof.result == prove::verify::ProofResult::kProved;
    // A function that only others call matters where it is why these are not proved.
    if (proof.exported) {
      Say(ProofText(proof, compilation_));
      all = all && proved;
    } else if (!proved) {
      causes += ProofText(proof, compilation_);
    }
  };
  proofs_ = prove::verify::Verify(emittable, *code, routines_, saying);
  if (!all && !causes.empty()) Say(causes);
  if (!CompareFrontEnd(emittable, limits)) all = false;
  for (const std::string& name : left_out_) Say("  " + name + ": left out\n");
  progress_.Show("proving facts");
  facts_beside.Wait();
  Say(facts_.Text());
  const std::string what = std::string(!left_out_.empty()          ? "what was asked for"
                                       : settings_.objects.empty() ? "the compiled code"
                                                                   : "the machine code") +
                           (settings_.target == "host" ? "" : " for " + settings_.target) + " is";
  verdict_ = compilation_.name + ": " + (all ? what + " proved equal to the program\n" : "not proved\n");
  if (!settings_.certificate.empty() && !WriteCertificate()) return false;
  return all && facts_.all_proved();
}

int RunVerify(const VerifySettings& settings) {
  const std::optional<uint64_t> routine_ms = ParseDuration(settings.time);
  if (!routine_ms || *routine_ms == 0) {
    return UsageError("'" + settings.time + "' is no time; write for example 30s");
  }
  if (!CanBeWritten({settings.certificate})) return kWrongUse;
  const compile::Target* target = compile::FindTarget(settings.target);
  if (target == nullptr) {
    return UsageError("'" + settings.target + "' is no target" +
                      support::ThereAre(settings.target, compile::TargetNames()));
  }
  OutputOptions names;
  names.name = settings.name;
  std::optional<compilation::CompilationRequest> request = MakeNamedRequest(settings.common, names);
  if (!request) return kWrongUse;
  std::vector<std::string> objects;
  for (const std::string& path : settings.objects) {
    std::optional<std::string> bytes =
        ReadNamedFile(path, "--object names an object or a library, as plcxx build wrote it");
    if (!bytes) return kWrongUse;
    objects.push_back(std::move(*bytes));
  }
  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request);
  if (!compiled) return kWrongUse;
  compilation::Compilation& compilation = *compiled;
  Verification verification(settings, *request, *target, *routine_ms, std::move(objects), compilation, progress);
  const bool proved = compilation.ok() && verification.Run();
  progress.Clear();
  PrintDiagnostics(compilation, MessagesOf(settings.common));
  if (settings.quiet && !proved) std::cerr << verification.said();
  if (!settings.quiet || !proved) std::cerr << verification.verdict();
  if (verification.is_wrong_use()) return kWrongUse;
  const int code = ExitCodeOf(compilation);
  return code == kDone && !proved ? static_cast<int>(kProgramHasErrors) : code;
}

}  // namespace

void AddVerify(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("verify", "Prove that the compiled code does what the program says");
  const auto settings = std::make_shared<VerifySettings>();
  AddCommonOptions(*command, settings->common);
  command->add_option("--name", settings->name, "Of the program; else from the first source with logic")
      ->type_name("N")
      ->group("Output");
  command->add_option("--certificate", settings->certificate, "Write what was proved, of what, and how: JSON")
      ->type_name("FILE")
      ->group("Output");
  command->add_option("--compiler", settings->compiler, "Clang 19, also behind a launcher; else clang++-19")
      ->type_name("CMD")
      ->group("Output");
  command->add_option("-O", settings->level, "Level of optimization; else 2")
      ->type_name("LEVEL")
      ->check(OneOf({"1", "2", "3", "s", "z"}))
      ->group("Output");
  command->add_option("--target", settings->target, "What to compile for, as in plcxx build; else this machine")
      ->type_name("T")
      ->group("Output");
  command->add_option("--object", settings->objects, "Verify this object or library, as plcxx build wrote it")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group("Output");
  command->add_option("--routine", settings->routines, "Only this one: init, fast, slow, period ...; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->group("Limits");
  command->add_option("--time", settings->time, "For one function, in time of the processor: as in 500ms, 60s or 5min")
      ->type_name("TIME")
      ->default_str("60s")
      ->group("Limits");
  command->add_option("-j,--jobs", settings->jobs, "Functions that are proved at a time; else one for each processor")
      ->type_name("N")
      ->check(CLI::Range(1U, 256U))
      ->group("Limits");
  command->add_option("--front-end", settings->front_end, "on, off: compare with what Clang makes of C (dialect hnc)")
      ->type_name("ON")
      ->check(OneOf({"on", "off", "only"}))
      ->group("Limits");
  command->add_flag("-q,--quiet", settings->quiet, "Tell only what is not proved")->group("Output");
  command->footer(kVerifyFooter);
  command->callback([settings, &run] { run = [settings] { return RunForPrograms(*settings, RunVerify); }; });
}

}  // namespace plcxx::driver
