#include "transpiler/sim/simulator.h"

namespace plcxx::sim {

void Simulator::PowerOn() {
  if (LastWrites* const writes = execution_.recorder.writes()) writes->Clear();
  execution_.memory.Clear();
  execution_.time = {};
  Run(execution_, execution_.program.schedule.init);
}

void Simulator::RunAt(uint32_t now_ms, ir::RoutineId partition) {
  execution_.time.GoTo(now_ms);
  RunPartition(execution_, partition);
}

void Simulator::RunPeriod(uint32_t now_ms) { RunAt(now_ms, execution_.program.schedule.period); }
void Simulator::RunFastOnly(uint32_t now_ms) { RunAt(now_ms, execution_.program.schedule.fast_only); }
void Simulator::RunElapse(uint32_t now_ms) { RunAt(now_ms, execution_.program.schedule.elapse); }

uint64_t Simulator::Read(const ir::Place& place) {
  return execution_.memory.Get(AccessTo(execution_.program, place), 0);
}

void Simulator::NoteWrite(Writer writer, const PlaceAccess& access) {
  if (execution_.recorder.is_on()) execution_.recorder.Note(execution_.memory, access, 0, WriteBy(execution_, writer));
}

void Simulator::Write(const ir::Place& place, uint64_t value) {
  const PlaceAccess access = AccessTo(execution_.program, place);
  execution_.memory.Set(access, 0, value);
  NoteWrite(Writer::kHost, access);
}

void Simulator::Force(const ir::Place& place, uint64_t value) {
  const PlaceAccess access = AccessTo(execution_.program, place);
  execution_.memory.Force(access, value);
  NoteWrite(Writer::kForce, access);
}

void Simulator::Release(const ir::Place& place) { execution_.memory.Release(AccessTo(execution_.program, place)); }

void Simulator::BeginAnew() {
  FindBases(execution_);
  execution_.host.TakeEvents();
  execution_.stopped = false;
}

void Simulator::Restore(const Saved& saved) {
  execution_.memory.Restore(saved);
  BeginAnew();
}

void Simulator::Exchange(Saved& other) {
  execution_.memory.Exchange(other);
  BeginAnew();
}

Simulator::Noted Simulator::SaveNoted() const {
  const LastWrites* const writes = execution_.recorder.writes();
  return {.time = execution_.time, .writes = writes != nullptr ? *writes : LastWrites()};
}

void Simulator::RestoreNoted(const Noted& noted) {
  execution_.time = noted.time;
  if (LastWrites* const writes = execution_.recorder.writes()) *writes = noted.writes;
}

}  // namespace plcxx::sim
