// Functions of the old form: parameters declared after the head, calls before the definition, int by default.
// shows: out int 20, l long 4
// sets: X[0] 255, X[1] 3, P[0] 50000
// sets: X[0] 100, X[1] 200, P[0] 7
int out[20];
long l[4];
init() { plc1_time = 1; plc2_time = 1; }
mix(a, b, c)
unsigned char a;
char b;
unsigned c;
{
  a += b; b -= a;
  return a * b + c;
}
long far_mix(x, y) long x; int y; { return x * y - (x >> 3); }
count() { static n; return n++; }
static unsigned half(n) unsigned n; { if (n & 1) return n / 2 + 1; return n / 2; }
void plc1()
{
  register i, j = 2;
  auto k = 0;
  unsigned n = P[0];
  const limit = 6;
  out[k++] = mix(X[0], X[1], n); out[k++] = mix(X[0] + 300, -X[1], n + 1); out[k++] = later(X[0] * 256, X[1]); out[k++] = count(); out[k++] = count() * 10;
  l[0] = far_mix((long) n, X[0]); l[1] = far_mix(-70000, -3); l[2] = half(n) * -1L; l[3] = later((int) l[0], (int) l[1]) ? 1 : 2;
  for (i = 0; i < limit; i++) out[k + i] = half(i) + later(i, j) * count();
}
void plc2() { }
later(a, b) { a ^= b; return a - b > 0 ? a : b; }
