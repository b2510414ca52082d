// Enumerations as states, as sizes and cases, in typedefs and in structs; negative ones and repeated values.
// shows: out int 24
// sets: X[0] 0
// sets: X[0] 3 cycles 4
// sets: X[0] 200
enum { OFF, ON = 5, AGAIN = ON, NEXT, LOW = -2, MINUS_ONE, ZERO, LIMIT = sizeof(long) * 3, MASK = 1 << 14 | 1, CHAR = 'A' };
typedef enum phase { IDLE_ = 10, CLAMP, TURN = CLAMP * 2, LOCK, DONE_ = -32767 - 1 } phase;
typedef unsigned char byte;
typedef byte row[LIMIT];
typedef struct { phase at; byte seen[NEXT]; row values; } machine;
machine m = {CLAMP, {1, ON}};
static phase last = DONE_;
int out[24];
phase follow(phase p, byte start)
{
  switch (p) {
  case IDLE_: return start ? CLAMP : IDLE_;
  case CLAMP: return TURN;
  case TURN: return start & 1 ? LOCK : CLAMP;
  case LOCK: case DONE_: return p == LOCK ? DONE_ : IDLE_;
  default: return p - 1;
  }
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0;
  m.at = follow(m.at, X[0]); last = follow(last, X[0]) + OFF; m.seen[NEXT - 1] += m.at; m.values[LIMIT - 1]++;
  out[i++] = m.at; out[i++] = last; out[i++] = m.seen[ON]; out[i++] = sizeof(machine); out[i++] = sizeof(phase) + sizeof(row);
  out[i++] = NEXT; out[i++] = MINUS_ONE; out[i++] = ZERO == OFF; out[i++] = MASK >> 1; out[i++] = CHAR; out[i++] = (enum phase) X[0] == CLAMP;
  out[i++] = (byte) DONE_; out[i++] = -DONE_; out[i++] = DONE_ < LOW; out[i++] = LOW * 2u > 0; out[i++] = m.values[11];
}
void plc2() { }
