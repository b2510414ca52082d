// Which functions and variables of the sources are which routines and bytes of the program (ir/reference.h).
#pragma once

#include <string>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/ir/reference.h"

namespace plcxx::hnc {

class CriticalSections;
class Faults;
class Handlers;
class HostCalls;
class Memory;
class Schedule;
class SystemRoutines;

class ReferenceWriter : Context {
 public:
  ReferenceWriter(const Context& context, HostCalls& host_calls, CriticalSections& critical, Faults& faults,
                  Memory& memory, SystemRoutines& system_routines, Handlers& handlers, Schedule& schedule)
      : Context(context),
        host_calls_(host_calls),
        critical_(critical),
        faults_(faults),
        memory_(memory),
        system_routines_(system_routines),
        handlers_(handlers),
        schedule_(schedule) {}

  /// Of the program that Run has given.
  ir::Reference Describe(const ir::Program& program) const;

 private:
  ir::ReferenceBytes BytesOf(ObjectId object) const;
  void DescribeAreas(const ir::Program& program, ir::Reference& reference) const;
  void DescribeVariables(ir::Reference& reference) const;
  /// What its head has that has no equal in the reference; empty: nothing.
  std::string WhyInCallers(const Function& function) const;
  void DescribeFunction(FunctionId id, ir::Reference& reference) const;
  void DescribeEffects(const ir::Program& program, ir::Reference& reference) const;
  void DescribeCallees(const ir::Program& program, ir::Reference& reference) const;

  HostCalls& host_calls_;
  CriticalSections& critical_;
  Faults& faults_;
  Memory& memory_;
  SystemRoutines& system_routines_;
  Handlers& handlers_;
  Schedule& schedule_;
};

}  // namespace plcxx::hnc
