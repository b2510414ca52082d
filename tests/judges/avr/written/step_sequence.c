// A sequence of states in a register byte: fall-through, default in the middle, a step twice in one scan.
// shows: trace unsigned char 12, t unsigned char 1, lost int 1
// sets: X[0] 1
// sets: X[0] 3 cycles 2
// sets: X[0] 0 cycles 3
// sets: X[0] 255 cycles 6
#define state R[10]
#define bit(n) (1 << (n))
unsigned char trace[12], t;
int lost;
void init() { plc1_time = 1; plc2_time = 2; state = 250; }
void plc1()
{
  static unsigned char at = 0;
  switch (state) {
  case 0:
    if (!(X[0] & bit(0))) break;
    state = 1;
    /* fall through */
  case 1:
    Y[0] |= bit(state);
    t = 3;
    state++;
    break;
  default:
    lost += state > 5 ? state : -state;
    state += 1;
    if (state != 0) break;
    /* fall through */
  case 2: case 3:
    if (--t) { Y[0] ^= bit(7); break; }
    Y[0] &= ~bit(1) & ~0x80;
    state = X[0] & bit(1) ? 4 : 5;
    break;
  case 5: state = 0; Y[0] = 0;
  case 4: if (state) state++;
  }
  trace[at] = state;
  if (++at >= sizeof trace / sizeof trace[0]) at = 0;
}
void plc2() { switch (X[0] & 3) default: lost++; }
