#include "transpiler/sim/trace.h"

#include <algorithm>

#include "transpiler/source/columns.h"

namespace plcxx::sim {

Watched Watch(const ir::Program& program, std::string name, const ir::Place& place) {
  std::string scope = place.is_field() ? std::string(ir::Info(program.states[place.state].kind).text)
                                       : program.spaces[place.space].name;
  return {.name = std::move(name), .scope = std::move(scope), .place = place, .cell = {}};
}

ReadWatched ReadsFrom(Engine& engine) {
  return [&engine](const Watched& watched) { return engine.Read(watched.place); };
}

void Trace::Record(uint64_t time_ms, const ReadWatched& read) {
  if (samples_.empty() || samples_.back().time_ms != time_ms) samples_.push_back({time_ms, {}});
  std::vector<uint64_t>& values = samples_.back().values;
  values.clear();
  for (const Watched& watched : watched_) values.push_back(read(watched));
}

std::string WriteTable(const Trace& trace) {
  std::vector<std::vector<std::string>> rows(1);
  rows[0].push_back("t/ms");
  for (const Watched& watched : trace.watched()) rows[0].push_back(watched.name);
  for (const Sample& sample : trace.samples()) {
    std::vector<std::string> row = {std::to_string(sample.time_ms)};
    for (size_t i = 0; i < sample.values.size(); ++i) {
      const Watched& watched = trace.watched()[i];
      row.push_back(ValueDigits(watched.place.type, sample.values[i], watched.sign));
    }
    rows.push_back(std::move(row));
  }
  std::vector<size_t> widths(rows[0].size());
  for (const std::vector<std::string>& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], source::ColumnsOf(row[i]));
  }
  std::string out;
  for (const std::vector<std::string>& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) out += (i == 0 ? "" : "  ") + source::RightAligned(row[i], widths[i]);
    out += '\n';
  }
  return out;
}

void Graph::Observe(uint64_t time_ms, const ReadWatched& read) {
  const Level level = read(options_.trigger) != 0 ? Level::kHigh : Level::kLow;
  if (phase_ == Phase::kArmed) {
    const Level before = options_.edge == Edge::kRising ? Level::kLow : Level::kHigh;
    if (level_ == before && level != before) {
      phase_ = Phase::kStarted;
      due_ms_ = time_ms + options_.delay_ms;
    }
  }
  level_ = level;
  if (phase_ != Phase::kStarted || time_ms < due_ms_) return;
  trace_.Record(time_ms, read);
  const uint64_t sampling = std::max(1u, options_.sampling_ms);
  due_ms_ += ((time_ms - due_ms_) / sampling + 1) * sampling;  // the grid stays where the edge has put it
  if (options_.samples != 0 && trace_.samples().size() >= options_.samples) phase_ = Phase::kComplete;
}

}  // namespace plcxx::sim
