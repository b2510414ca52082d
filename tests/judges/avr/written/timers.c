// On-delay, off-delay, pulses and blinkers with bytes and words that count scans; a clock in BCD.
// shows: on unsigned char 4, t unsigned char 4, clock unsigned char 3, lamp unsigned 1, since long 1
// sets: X[0] 3 cycles 4
// sets: X[0] 6 cycles 5
// sets: X[0] 1 cycles 30
// sets: X[0] 8 cycles 2
unsigned char on[4], t[4], clock[3] = {0x58, 0x59, 0x23};
unsigned lamp;
long since = -3;
static void on_delay(int k, unsigned char preset) { if (X[0] >> k & 1) { if (t[k] < preset) t[k]++; else on[k] = 1; } else on[k] = t[k] = 0; }
static void off_delay(int k, unsigned char preset) { if (X[0] & 1 << k) { on[k] = 1; t[k] = preset; } else if (on[k] && !--t[k]) on[k] = 0; }
static char tick(unsigned char *digit, unsigned char end) { ++*digit; if ((*digit & 15) == 10) *digit += 6; if (*digit == end) { *digit = 0; return 1; } return 0; }
void init() { plc1_time = 1; plc2_time = 2; }
void plc1()
{
  static unsigned char old;
  unsigned char edge = (X[0] ^ old) & X[0];
  old = X[0];
  on_delay(0, 3); off_delay(1, 4); on_delay(2, 0); if (edge & 8) t[3] = 250; if (t[3]) { t[3] += 3; on[3] = t[3] < 253; }
  if (tick(&clock[0], 0x60) && tick(clock + 1, 0x60)) tick(&clock[2], 0x24);
  lamp = lamp << 1 | !!(lamp & 0x8000) ^ (edge != 0);
  if (since++ == 0) lamp |= 0x0F00; else if (since % 5 == 0 || since % -7 == 1) lamp ^= 0x00F0;
}
void plc2() { Y[0] ^= t[0] ? 1 : 0x80; Y[1] = Y[1] * 2 + !(Y[1] & 0x44); }
