// What is known of a number beside the bytes, the fields and the other types that change it.
// shows: out long 60
// sets: X[0] 8, X[1] 0, X[2] 5, X[3] 200, F[0] 65535, F[1] 3
// sets: X[0] 23, X[1] 1, X[2] 9, X[3] 3, F[0] 32768, F[1] 1000
// sets: X[0] 255, X[1] 128, X[2] 0, X[3] 127, F[0] 5, F[1] 65535
union wide { long l; unsigned long ul; int i[2]; unsigned u[2]; unsigned char b[4]; char c[4]; float f; };
long out[60];
union wide w;
int table[10];
int total;
int clip(int v) { if (v < -3) return -3; if (v > 7) return 7; return v; }
unsigned char low(unsigned v) { return v; }
int parts(int a) { if (a > 100) return a; if (a < -100) return -a; return 0; }
int *pick(int n) { return n & 1 ? &table[3] : &table[7]; }
void bump(int *p, int by) { *p += by; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i, k = 0, n, m, z[4]; unsigned u; unsigned char c; char s; long l; unsigned long ul; int *p;
  total = 0;
  w.l = 3; w.b[1] = 1; out[k++] = w.i[0] < 10; out[k++] = w.l > 255;
  w.l = -1; out[k++] = w.u[0] > 0; out[k++] = w.i[1] < 0; out[k++] = w.ul > 5; out[k++] = w.b[3] == 255; out[k++] = w.c[3] == -1;
  w.i[0] = 7; w.c[0] = -7; out[k++] = w.i[0] < 0; out[k++] = w.i[0];
  w.f = 1.0; out[k++] = w.l > 100; out[k++] = w.b[3]; w.l = 5; w.f = 0.0; out[k++] = w.l == 5;
  c = X[3]; s = c; out[k++] = s < 0; out[k++] = c > s; out[k++] = (s & 0xFF) == c; out[k++] = s == c;
  u = *F_ui[0]; n = u; out[k++] = n < 0; out[k++] = u > 32767; out[k++] = n == (int) u; out[k++] = (long) n == (long) u;
  if (n >= 0) out[k++] = u < 32768; else out[k++] = u > 32767;
  if (c < 128) { s = c; out[k++] = s >= 0; } else { s = c; out[k++] = s; }
  n = clip(X[0]); out[k++] = n > 7; out[k++] = n; out[k++] = clip(-X[0]) < -2; out[k++] = low(X[0] << 4) > 15; out[k++] = parts(X[0] - X[3]);
  p = pick(X[1]); for (i = 0; i < 10; i++) table[i] = i; *p = 50; out[k++] = table[3] == 3; out[k++] = table[7] > 7; out[k++] = p - table;
  total = 3; bump(&total, 40); out[k++] = total < 10; out[k++] = total;
  n = 4; p = &n; *p = 9; out[k++] = n == 4; for (i = 0, m = 0; i < n; i++) m++; out[k++] = m;
  for (i = 0; i < 4; i++) z[i] = X[i] ? X[i] : -1;
  for (i = 0, m = 0; i < 4; i++) if (z[i] > 0 && z[i] < 10) m += z[i]; out[k++] = m;
  l = X[0]; l <<= 12; out[k++] = l > 65535; ul = l; out[k++] = ul >> 12 == X[0]; out[k++] = -l < 0; out[k++] = (int) l < 0;
  for (c = 250, m = 0; c > 5; c++) m++; out[k++] = m; out[k++] = c;
  for (s = 120, m = 0; s > 0 && m < 300; s += 3) m++; out[k++] = m; out[k++] = s;
  for (u = 3, m = 0; u < 10; u--) m++; out[k++] = m; out[k++] = u;
  n = X[2] - 5; if (n == 0) out[k++] = n ? 1 : 2; else if (n > 0) out[k++] = n - 1 >= 0; else out[k++] = n < -4;
  n = X[2]; if (!(n > 5 || n < 3)) out[k++] = n < 6; else out[k++] = n;
  if (!(n >= 5 && n <= 8)) out[k++] = n == 5; else out[k++] = n == 5;
  n = X[0] ? X[1] ? 4 : 6 : 8; out[k++] = n > 5; n = (X[0] > 100 ? 3 : -3) * (X[1] > 100 ? 2 : -2); out[k++] = n > 0;
  m = 5; do { m--; n = m; } while (m > 0 && n != 2); out[k++] = m == 0; out[k++] = n; 
  for (n = 0, i = 5; i; i--) { n = i; if (X[1] == 1) continue; if (i == 3) break; } out[k++] = n == 1; out[k++] = i;
  out[k++] = (i = 3, i > 2) && (i = X[0]) > 2; out[k++] = i == 3;
}
void plc2() { }
