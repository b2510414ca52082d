// Tool numbers and spindle speeds between binary and BCD, with bytes that overflow on the way.
// shows: bcd unsigned 16, back long 16, bad unsigned char 16, packed unsigned long 4
// sets: P[0] 9999, P[1] 1234, P[2] 65535, P[3] 100, X[0] 153, X[1] 170
// sets: P[0] 0, P[1] 10000, P[2] 32768, P[3] 9, X[0] 9, X[1] 255
unsigned bcd[16];
long back[16];
unsigned char bad[16];
unsigned long packed[4];

unsigned to_bcd(unsigned n)
{
  unsigned r = 0;
  unsigned char digit;
  for (digit = 0; digit < 4; digit++) {
    r |= n % 10 << digit * 4;
    n /= 10;
  }
  return n ? 0xEEEE | n : r;
}
long from_bcd(unsigned long n)
{
  long r = 0, weight = 1;
  int k;
  for (k = 0; k != 32; k += 4, weight *= 10) r += (n >> k & 0xF) * weight;
  return r;
}
int is_bcd(unsigned char b) { return (b & 0x0F) < 10 && b >> 4 < 10; }

void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i;
  for (i = 0; i < 4; i++) {
    bcd[i] = to_bcd(P[i]);
    bcd[i + 4] = to_bcd(P_i[i] < 0 ? -P_i[i] : P_i[i]);
    bcd[i + 8] = to_bcd(P_uc[i]) + to_bcd(P_c[i]);
    bcd[12 + i] = to_bcd(~P[i]);
    back[i] = from_bcd(bcd[i]);
    back[i + 4] = from_bcd((long) bcd[i] << 16 | bcd[i + 4]);
    back[i + 8] = from_bcd(bcd[i] * 0x10001L);
    back[i + 12] = from_bcd(-1L >> i) - from_bcd((unsigned) -1);
    packed[i] = (unsigned long) bcd[i] << 16 | bcd[i + 4] >> 4;
    bad[i] = is_bcd(X[i]) << i | is_bcd(P_uc[i]) << 7;
    bad[i + 4] = !is_bcd(X[0] + i) * 200 + 100;
  }
}
void plc2() { }
