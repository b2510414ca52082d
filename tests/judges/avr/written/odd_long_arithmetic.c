// Longs between ints: where the width of an operation is decided, shifts by variables, divisions with every sign, carries.
// shows: l long 70
// sets: X[0] 7, X[1] 200, P[0] 65535, P[1] 32767, P[2] 3
// sets: X[0] 0, X[1] 15, P[0] 0, P[1] 32768, P[2] 65533
// sets: X[0] 31, X[1] 1, P[0] 4464, P[1] 1, P[2] 40000
long l[70]; static unsigned long u32; static long s32; static short sh; static unsigned short us;
long mix(int a, unsigned b, long c, unsigned long d) { return a * b + c * d - (a + c) * (b - d); }
unsigned long widen(unsigned char b, char c, int i) { return b * 256 + c + i; }
int low(long v) { return v; } unsigned high(unsigned long v) { return v >> 16; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i = P_i[2], n = X[0] & 15; unsigned u = P[1]; long a = P_l[0], b = P_i[2]; unsigned long c = P_l[0], d = P[2]; unsigned char x = X[1]; char y = X[1];
  if (!b) b = 1; if (!d) d = 1; if (!i) i = 1;
  l[k++] = a + u; l[k++] = a - i; l[k++] = a * i; l[k++] = a * u; l[k++] = c * i; l[k++] = a / b; l[k++] = a % b; l[k++] = c / d; l[k++] = c % d; l[k++] = a / d; l[k++] = a % d; l[k++] = c / b; l[k++] = -a / 7; l[k++] = -a % 7; l[k++] = a / -7; l[k++] = a % -7; l[k++] = (a - 1) / 2 * 2;
  l[k++] = a << n; l[k++] = a >> n; l[k++] = c >> n; l[k++] = c << (X[0] & 31); l[k++] = c >> (X[0] & 31); l[k++] = a >> (X[0] & 31); l[k++] = i << n; l[k++] = i >> n; l[k++] = u << n; l[k++] = u >> n; l[k++] = x << n; l[k++] = y >> (n & 7); l[k++] = (long) i << n; l[k++] = (long) (i << n); l[k++] = 1L << (X[0] & 31); l[k++] = 1 << n; l[k++] = (1 << n) - 1; l[k++] = ~0UL >> (X[0] & 31); l[k++] = -1L << n;
  l[k++] = mix(i, u, a, c); l[k++] = mix(-1, 1, -1, 1); l[k++] = widen(x, y, i); l[k++] = widen(255, -1, -1); l[k++] = low(a) + low(a >> 16); l[k++] = high(a) - high(c + 1); l[k++] = (a ^ c) | (a & u) | (c & i); l[k++] = ~a + ~c + ~u; l[k++] = -(u + 0L) + -u;
  u32 = a; u32 += i; u32 -= 70000; u32 *= x; l[k++] = u32; u32 /= d; u32 %= 1000; u32 <<= n; u32 >>= 3; u32 ^= -1; u32 |= y; u32 &= ~(unsigned) n; l[k++] = u32;
  s32 = c; s32 -= u; s32 *= -3; l[k++] = s32; s32 /= i; l[k++] = s32; s32 >>= n & 7; s32 <<= 3; s32 %= 777; l[k++] = s32; s32 ^= u; s32 |= i; s32 &= x | ~0xFFL; l[k++] = s32;
  sh = a; sh += u; l[k++] = sh; sh *= sh; l[k++] = sh; sh >>= 2; sh -= y; l[k++] = sh; us = a; us += c; us *= us; l[k++] = us; us /= x + 1; us <<= n; l[k++] = us; us = -us; l[k++] = us; l[k++] = us * us; l[k++] = us * (long) us; l[k++] = sh * us;
  l[k++] = a > u; l[k++] = a > c; l[k++] = a == c; l[k++] = i > u; l[k++] = b > u; l[k++] = (long) i > u; l[k++] = (a < 0) + (c < 0) * 2 + (a < -1) * 4;
}
void plc2() { }
