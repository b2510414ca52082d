// What a report is made from: a program, its sources, and what was generated from it. Plain data; the driver fills it.
//
// In: everything that only the driver can reach (generated files, the dialect's names, the compile report's figures).
// Not its job: anything that the IR itself tells (uses, memory map, costs, ladder): the report finds that by itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::report {

/// A generated C++ file.
struct GeneratedFile {
  std::string name;  // without directory
  std::string text;
  /// From `line` on (counted from 1, ascending) the text is that statement's; none: the control's own, or nobody's.
  struct Owner {
    uint32_t line = 0;
    ir::StatementId statement;
  };
  std::vector<Owner> owners;
};

struct Partition {
  std::string name;         // "fast"
  uint64_t time_ns = 0;     // estimated, longest path
  uint64_t code_bytes = 0;  // estimated
  uint64_t limit_ns = 0;    // of its budget; 0: none
};

/// A table of the dialect that the report shows as it is.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as `columns`
};

struct ProgramInput {
  /// Optimized and cut into slices, as it is emitted and executed.
  const ir::Program* program = nullptr;
  const source::SourceManager* sources = nullptr;
  std::vector<source::FileId> files;  // of the program, in the user's order; included ones are found by statements
  std::string control;                // "Balt-System NC-110 ... NC-400"
  std::vector<GeneratedFile> generated;
  std::vector<std::string> local_names;  // by InstId: of a value that generated code keeps in a local; may be short
  std::vector<std::optional<ir::Place>> documented;  // by index into Program::documentation: what the address names
  std::vector<Partition> partitions;
  uint32_t slices = 1;
  uint32_t slow_period_ms = 0;  // of a whole slow part; 0: none that is the same for each
  std::vector<Table> tables;
};

}  // namespace plcxx::report
