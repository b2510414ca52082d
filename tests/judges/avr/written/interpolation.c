// A table with interpolation, a ramp, a filter of the first order and hysteresis: fixed point in int and long.
// shows: out int 16, filtered long 2, speed int 1, on unsigned char 2
// sets: P[0] 0, P[1] 1000, X[0] 10
// sets: P[0] 350, P[1] 64536, X[0] 200 cycles 3
// sets: P[0] 65535, P[1] 0, X[0] 128 cycles 5
const int curve[6][2] = {{-100, -32000}, {0, 0}, {50, 700}, {300, 5}, {301, 32767}, {1000, -1}};
int out[16], speed;
long filtered[2];
unsigned char on[2];
int at(int x)
{
  int i;
  if (x <= curve[0][0]) return curve[0][1];
  for (i = 1; i < 6; i++)
    if (x < curve[i][0]) {
      long dx = curve[i][0] - curve[i - 1][0], dy = (long) curve[i][1] - curve[i - 1][1];
      return curve[i - 1][1] + (int) (dy * (x - curve[i - 1][0]) / dx);
    }
  return curve[5][1];
}
int limited(long v, int low, int high) { return v < low ? low : v > high ? high : v; }
int ramp(int now_, int to, unsigned char by)
{
  if (to - now_ > by) return now_ + by;
  if (now_ - to > (int) by) return now_ - by;
  return to;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i;
  for (i = 0; i < 16; i++) out[i] = at(P_i[0] + i * 40 - 150) - at(-i * 9);
  speed = ramp(speed, P_i[1], X[0]);
  filtered[0] += ((long) P_i[1] * 256 - filtered[0]) >> 3; filtered[1] += (P_i[1] * 16L - filtered[1]) / 8;
  out[0] = limited(filtered[0], -500, 500); out[1] = limited(filtered[1] * filtered[0], -32767, 32767); out[2] = limited(speed * speed, 0, 100);
  on[0] = on[0] ? speed > 100 : speed > 200; on[1] = speed > (on[1] ? X[0] : -X[0]);
}
void plc2() { }
