// A program whose slow part is cut into slices, as the proofs see it with its slices: inputs are new before each of
// them.
//
// In: the machine whose slow part is one piece (property_machine.h). Out: a machine whose period is a pass slice by
// slice, properties in its cells, and its runs in those of the other one. Not its job: proving.
#pragma once

#include <vector>

#include "transpiler/passes/whole_pass.h"
#include "transpiler/prove/properties/result.h"
#include "transpiler/scenarios/property_machine.h"

namespace plcxx::scenarios {

struct PassMachine {
  std::string refusal;  // not empty: the rest is of no use, and why; lower case, no full stop
  compilation::Compilation compilation;
  prove::machine::Version version;
  passes::WholePass pass;
  std::vector<passes::ByteBetweenSlices> bytes;  // what is new before each slice
};

/// Of a request whose program compiles and has slices. The machine must not be moved after.
void MakePassMachine(const compilation::CompilationRequest& request, PassMachine& pass);

/// The same property of the pass.
prove::properties::Property InPass(const prove::properties::Property& property, const ProveMachine& machine,
                                   const PassMachine& pass);
/// A run of passes as one of `machine`: the parts of a period are its slices.
prove::properties::PropertyRun FromPass(const prove::properties::PropertyRun& run, const ProveMachine& machine,
                                        const PassMachine& pass);

}  // namespace plcxx::scenarios
