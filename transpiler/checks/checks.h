// The checks that are the same in every dialect: each finds, the dialect's message words it (diagnostics/lints.h).
//
// In: a structured program before slicing; the dialect's rows. Out: warnings. One file per check.
#pragma once

#include <vector>

#include "transpiler/checks/accesses.h"
#include "transpiler/diagnostics/lints.h"

namespace plcxx::checks {

/// Runs every check that the dialect has a message for and that is switched on.
void RunAll(const ir::Program& program, const diag::Lints& lints, diag::Engine& diagnostics);

struct Context {
  const ir::Program& program;
  const std::vector<PartAccesses>& parts;
  diag::Engine& diagnostics;
};

/// One instance stepped in the fast and in the slow part: reported where the later part drives it.
void DrivenInBothParts(const Context& context, const diag::Message<diag::Text>& message);
/// Two statements step one instance and both can be executed in one run: reported at the second.
void DrivenTwice(const Context& context, const diag::Message<diag::Text>& message);
/// A field is read that nothing drives or writes: reported at the first read of the instance.
void ReadNeverDriven(const Context& context, const diag::Message<diag::Text>& message);
/// The carry of a counter of the fast part is read in a slow part of several slices.
void SlicedCarryRead(const Context& context, const diag::Message<diag::Text>& message);
/// The same bit, or a bit and its word, written in both parts: reported where the later part writes it.
void WrittenInBothParts(const Context& context, const diag::Message<diag::Text>& message);
/// Two unconditional writes without a read in between: reported at the second.
void DoubleCoil(const Context& context, const diag::Message<diag::Text>& message);
/// A write that is overwritten in the same run before anything reads it: reported at the lost one.
void DeadStore(const Context& context, const diag::Message<diag::Text>& message);

}  // namespace plcxx::checks
