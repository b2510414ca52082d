// Comparisons and divisions between int, unsigned, long and unsigned long.
// shows: less unsigned 64, rest long 64, quot unsigned long 64
// sets: P[0] 65535, P[1] 1, P[2] 32768, P[3] 40000
// sets: P[0] 32767, P[1] 65534, P[2] 3, P[3] 65535
unsigned less[64];
long rest[64];
unsigned long quot[64];
void row(int at, int i, unsigned u, long l, unsigned long ul)
{
  less[at] = (i < u) | (i < l) << 1 | (i < ul) << 2 | (u < l) << 3 | (u < ul) << 4 | (l < ul) << 5 | (i > -1) << 6 | (u > -1) << 7
      | (l > -1) << 8 | (ul > -1) << 9 | (i >= 40000) << 10 | (u >= 40000) << 11 | (l == -1) << 12 | (ul == -1) << 13 | (u == -1) << 14;
  rest[at] = i / 7 + u / 7 - l / 7 * (i % 7) + (u % 7) * (l % 7);
  rest[at + 1] = -i / 3 + -u / 3 + -l / 3;
  rest[at + 2] = i * u + l - (u - i) * 2;
  rest[at + 3] = (i ? i : u) - (u ? l : ul);
  quot[at] = ul / 7 + i / 3;
  quot[at + 1] = ul / (u | 1) - l % 1000;
  quot[at + 2] = i + ul * u;
  quot[at + 3] = (unsigned char) i * (char) u + (int) ul;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k;
  for (k = 0; k < 16; k++) row(4 * k, P_i[k & 3], P[k >> 2], P_l[k & 1] - k, P_ul[k >> 1 & 1] * k);
}
void plc2() { }
