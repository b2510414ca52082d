// The warnings and notes of dialect host50 (specification 10.3): W01 to W21, N01, N02, N04 to N06.
//
// In: a whole tree. Out: diagnostics only. N03 belongs to the rung machine. What a missing or misread part could cause
// is asked of a tree without errors only.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/host50/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

/// All of them, by the functions below.
void CheckProgram(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);

/// W01, W02, W03, W07, W08, W11, W12, N04: who reads and writes which address.
void CheckAccesses(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);
/// W21: signals of a constant axis that a block and the program write.
void CheckAxisSignals(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);
/// W05, W06, W09, W16, W19, N05: sections, jumps and calls.
void CheckFlow(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);
/// W04, W10, W17, W20, N01, N02: single instructions.
void CheckInstructions(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);
/// W13, W18: lengths of texts, M codes.
void CheckTexts(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);
/// W14: networks that the control's editor cannot show (10.1).
void CheckLayout(const Program& program, diag::Engine& diagnostics);
/// W15: more of something than the control has.
void CheckResources(const Program& program, diag::Engine& diagnostics);
/// N06.
void CheckEncodings(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);

}  // namespace plcxx::host50
