// Calls in calls, narrow parameters and results, old definitions, many parameters, functions without a result, results that are dropped.
// shows: l long 50, log int 20
// sets: X[0] 5, X[1] 200, P[0] 65535
// sets: X[0] 130, X[1] 0, P[0] 300
long l[50]; int log[20]; int at;
char nc(char c) { return c + 1; } unsigned char nb(b) unsigned char b; { return b - 1; } unsigned nu(u, i) unsigned u; int i; { return u / i; } long nl(a, b, c) long a; char b; unsigned c; { return a + b * c; }
plain(x) { return x * 2; } void note(int v) { if (at < 20) log[at++] = v; } int both(int a, int b) { note(a); return a * 3 - b; }
int many(char a, unsigned char b, int c, unsigned d, long e, unsigned long f, short g, int h, int i, int j) { return a + b + c + d + e + f + g - h * i + j; }
int early(int v) { if (v < 0) return -1; if (v > 100) { note(v); return 100; } return v; }
void out(int *p, long *q, unsigned char *r) { *p = *q; *q = *r; *r = *p; }
int chain(int a) { return a > 0 ? early(a - 50) : early(-a); }
unsigned char truth(int v) { return v; } int flag(long v) { return v != 0; } short sh(long v) { return v >> 8; } unsigned long ul(unsigned char b) { return ~b; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i = P[0]; long q = X[1]; unsigned char r = X[0];
  at = 0; l[k++] = nc(nc(nc(X[0] + 120))); l[k++] = nb(nb(X[1])); l[k++] = nb(0); l[k++] = nu(P[0], 2); l[k++] = nu(-1, -1); l[k++] = nl(100000L, 'x', 40000u); l[k++] = nl((long) X[0], X[1], P[0]); l[k++] = plain(X[0]) + plain(plain(2)); l[k++] = plain(20000);
  l[k++] = both(both(X[0], 1), both(2, both(3, 4))); l[k++] = many(X[1], X[1], X[1], -1, -1, -1, P[0], X[0], 2, -3); l[k++] = many(-1, -1, -1, 1, 65536, 1, 40000, i, i, i);
  l[k++] = early(X[1]); l[k++] = early(-X[0]); early(500); l[k++] = chain(X[0]) * 1000 + chain(X[1]) + chain(-7); out(&i, &q, &r); l[k++] = i; l[k++] = q; l[k++] = r; out(&i, &q, &R[3]); l[k++] = R[3]; l[k++] = q;
  l[k++] = truth(256) ? 1 : 2; l[k++] = truth(P[0]) == P[0]; l[k++] = flag(65536L) + flag(0x8000) * 10; l[k++] = sh(0x12345678); l[k++] = sh(-1L - X[0]); l[k++] = ul(X[0]); l[k++] = (unsigned char) ul(X[0]) + 1; l[k++] = -nb(X[0]) / 2; l[k++] = nc(127) < 0; l[k++] = (nc(127), nb(1)) == 0 && both(9, 9); l[k++] = both(X[0] ? early(3) : nc(4), X[1] && early(7));
}
void plc2() { }
