// What surrounds one function while it is executed on both sides: functions that are replaced, loops, and the host.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/prove/verify/host_environment.h"
#include "transpiler/prove/verify/loop_relation.h"
#include "transpiler/prove/verify/verified_program.h"

namespace plcxx::prove::verify {

/// The calls that are replaced while one function is executed, on either side.
class Replaced : public execute::ReplacedParts {
 public:
  /// `proved`: functions that are proved are replaced, too, and not only those that the code does not define.
  /// `on_fault`: told when the program calls what the code's language says nothing of.
  Replaced(const VerifiedProgram& program, const Workplace& workplace, terms::TermId hash, CallLog log, bool proved,
           std::function<void(terms::TermId when, terms::TermId code)> on_fault)
      : program_(program),
        workplace_(workplace),
        hash_(hash),
        log_(std::move(log)),
        proved_(proved),
        on_fault_(std::move(on_fault)) {}

  std::optional<std::vector<execute::CellChange>> Call(execute::Memory& memory, ir::RoutineId routine,
                                                       terms::TermId when) override {
    if (program_.shape.IsUpToFaults() && routine == program_.shape.fault) {
      on_fault_(when, memory.ReadPlace(program_.ir.places[program_.ir.routines[routine].parameter_places.front()]));
      return std::vector<execute::CellChange>();
    }
    const ReplacedCall* call = Of(program_.units.of_routines[routine.index]);
    return call == nullptr ? std::nullopt : std::optional(call->OnCells(memory, hash_, when, log_));
  }
  std::optional<std::vector<execute::CellChange>> Part(execute::Memory& memory, ir::RegionId region, uint32_t& at,
                                                       terms::TermId when) override {
    const UnitId unit = program_.units.At(program_.emittable, region, at);
    const ReplacedCall* call = Of(unit);
    if (call == nullptr) return std::nullopt;
    at = call->unit().part.end;
    return call->OnCells(memory, hash_, when, log_);
  }
  CallLog& log() { return log_; }
  const ReplacedCall* OfFunction(std::string_view name) const {
    for (uint32_t i = 0; i < workplace_.calls.size(); ++i) {
      const ReplacedCall* one = Of(UnitId(i));
      if (one != nullptr && name.ends_with(one->unit().name) && program_.CppName(one->unit()) == name) return one;
    }
    return nullptr;
  }

 private:
  const ReplacedCall* Of(UnitId unit) const {
    if (!unit.valid()) return nullptr;
    return proved_ ? workplace_.calls[unit.index] : program_.unknown[unit.index].get();
  }

  const VerifiedProgram& program_;
  const Workplace& workplace_;
  terms::TermId hash_;
  CallLog log_;
  bool proved_;
  std::function<void(terms::TermId when, terms::TermId code)> on_fault_;
};

/// The host, the functions that are replaced, and loops; there need not be any of these.
class UnitEnvironment : public HostEnvironment {
 public:
  UnitEnvironment(terms::Terms& terms, const VerifiedProgram& program, terms::TermId now, Replaced* replaced,
                  LoopRelation* loops, std::function<terms::TermId(uint32_t slot)> initial,
                  std::function<bool(terms::TermId condition)> never_holds)
      : HostEnvironment(terms, program.emittable, program.cells, program.image, program.shape.passes, now,
                        std::move(initial)),
        terms_(terms),
        program_(program),
        replaced_(replaced),
        loops_(loops),
        never_holds_(std::move(never_holds)) {}

  bool Replaces(std::string_view function) const override {
    return replaced_ != nullptr && replaced_->OfFunction(function) != nullptr;
  }
  terms::TermId CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) override {
    const ReplacedCall* call = replaced_ == nullptr ? nullptr : replaced_->OfFunction(request.function);
    if (call != nullptr) return call->OnCode(terms_, memory, request, replaced_->log(), refusal);
    if (program_.shape.passes == Passes::kNothing) return CallControl(memory, request, refusal);
    return HostEnvironment::CallHost(memory, request, refusal);
  }
  bool NeverHolds(terms::TermId condition) override { return never_holds_(condition); }
  void OpenLoop() override { loops_->OpenInCode(); }
  std::vector<terms::TermId> AtHead(const CodeLoop& loop) override { return loops_->AtHeadInCode(loop); }
  void CloseLoop(terms::TermId again, std::span<const terms::TermId> values) override {
    loops_->CloseInCode(again, values);
  }
  terms::TermId Given() override { return loops_ == nullptr ? terms::TermId() : loops_->given_in_code(); }

 private:
  /// A function of the library, or of the host, which is not passed.
  terms::TermId CallControl(CodeMemory& memory, const HostRequest& request, std::string& refusal);

  terms::Terms& terms_;
  const VerifiedProgram& program_;
  Replaced* replaced_;
  LoopRelation* loops_;
  std::function<bool(terms::TermId condition)> never_holds_;
};

}  // namespace plcxx::prove::verify
