// The records of the characterisation files IOCFIL, AXCFIL and PGCFIL that the compiler reads (specification 9.5).
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

enum class RecordFile : uint8_t { kIocfil, kAxcfil, kPgcfil };

/// Puts the records of `file` into `settings`; records that it does not know are passed over.
void ReadRecords(const source::SourceManager& sources, source::FileId file, RecordFile kind, Settings& settings,
                 diag::Engine& diagnostics);

}  // namespace plcxx::nc110
