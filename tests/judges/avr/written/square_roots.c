// Integer roots, greatest divisors, powers: loops with bounds that the writer gives.
// shows: root unsigned 16, gcd unsigned 16, power long 16
// sets: P[0] 65535, P[1] 255, X[0] 3
// sets: P[0] 2, P[1] 32768, X[0] 251
unsigned root[16], gcd[16];
long power[16];
unsigned isqrt(unsigned long n)
{
  unsigned long r = 0, bit = 1UL << 30;
  int k;
  for (k = 0; k < 16; k++, bit >>= 2) {
    if (n >= r + bit) { n -= r + bit; r = (r >> 1) + bit; } else r >>= 1;
  }
  return r;
}
unsigned divisor(unsigned a, unsigned b)
{
  unsigned t;
  //@loop_bound 30
  while (b) { t = a % b; a = b; b = t; }
  return a;
}
long raised(int b, unsigned char n)
{
  long r = 1, f = b;
  unsigned char k;
  for (k = 0; k < 8; k++) { if (n >> k & 1) r *= f; f *= f; }
  return r;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  unsigned i;
  for (i = 0; i < 16; i++) {
    root[i] = isqrt((unsigned long) P[0] * (P[1] + i) + i);
    gcd[i] = divisor(P[0] - i * 17, P[1] + i);
    power[i] = raised(X_c[0], i) - raised(X[0], i);
  }
}
void plc2() { }
