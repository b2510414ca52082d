// An absolute encoder in Gray code, with a count of turns, and an incremental one by table of transitions.
// shows: position int 2, turns char 1, angle unsigned 1, errors unsigned char 1, reversals int 1
// sets: X[0] 12, X[1] 0
// sets: X[0] 200, X[1] 1
// sets: X[0] 128, X[1] 3 cycles 2
// sets: X[0] 0, X[1] 2
// sets: X[0] 129, X[1] 1
// sets: X[0] 255, X[1] 2
const signed char transition[16] = {0, 1, -1, 2, -1, 0, 2, 1, 1, 2, 0, -1, 2, -1, 1, 0};
int position[2], reversals;
char turns;
unsigned angle;
unsigned char errors;
unsigned char gray(unsigned char b) { return b ^ b >> 1; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  static unsigned char old, old_pair; static signed char way;
  unsigned char new_ = gray(X[0]), b, pair; signed char step;
  b = new_; b ^= b >> 4; b ^= b >> 2; b ^= b >> 1;
  step = b - old; turns += b < old && step > 0 ? 1 : b > old && step < 0 ? -1 : 0; position[0] = turns * 256 + b; angle = (unsigned) b * 360 / 256 + (turns & 1) * 360u; old = b;
  pair = (old_pair << 2 | X[1] & 3) & 15; old_pair = pair; step = transition[pair];
  if (step == 2) errors++; else { position[1] += step; if (step && step == -way) reversals++; if (step) way = step; }
}
void plc2() { }
