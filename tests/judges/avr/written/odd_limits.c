// Limits and counters that something in the loop reads, changes or looks at in another way.
// shows: out long 60
// sets: X[0] 8, X[1] 0, X[2] 5, X[3] 200, F[0] 65535, F[1] 3
// sets: X[0] 23, X[1] 1, X[2] 9, X[3] 3, F[0] 32768, F[1] 1000
// sets: X[0] 255, X[1] 128, X[2] 0, X[3] 127, F[0] 5, F[1] 65535
struct pair { int n, m; };
struct bits { unsigned a : 3; unsigned b : 5; int c : 8; };
long out[60];
int g, h; struct pair q; struct bits f; int t[20];
int next(void) { return ++g; }
int shrink(int by) { h -= by; return h; }
void set(struct pair *p, int v) { p->n = v; }
struct pair made(int v) { struct pair r; r.n = v; r.m = v + 1; return r; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i, j, k = 0, m; unsigned u; unsigned char c; char s; long l; int *p; struct pair r;
  g = 0; 
#pragma plcxx loop_bound(30000)
for (i = 0, m = 0; i < 12; i = next()) m++; out[k++] = m;
  h = 20; for (i = 0, m = 0; i < h && m < 90; i++) { if (i & 1) shrink(2); m++; } out[k++] = m; out[k++] = h;
  q.n = 6; 
#pragma plcxx loop_bound(30000)
for (i = 0, m = 0; i < q.n; i++) { if (i == 3) set(&q, 9); m++; if (m > 50) break; } out[k++] = m;
  r = made(4); for (i = r.n, m = 0; i < r.m + 4; i++) m++; out[k++] = m; 
#pragma plcxx loop_bound(30000)
for (r.n = 0; r.n < 7; r.n++) { if (r.n == 2) r = made(5); m++; if (m > 90) break; } out[k++] = m; out[k++] = r.n;
  f.a = 0; 
#pragma plcxx loop_bound(30000)
for (m = 0; f.a < 7; f.a++) m++; out[k++] = m; 
#pragma plcxx loop_bound(30000)
for (m = 0; f.a; f.a--) m++; out[k++] = m;
  f.b = 3; 
#pragma plcxx loop_bound(30000)
for (m = 0; f.b < 20; f.b += 4) m++; out[k++] = m; out[k++] = f.b; f.c = -5; 
#pragma plcxx loop_bound(30000)
for (m = 0; f.c < 5; f.c = f.c + 2) m++; out[k++] = m; out[k++] = f.c;
  f.c = 100; for (m = 0; f.c > 0 && m < 200; f.c++) m++; out[k++] = m; out[k++] = f.c;
  
#pragma plcxx loop_bound(30000)
for (i = 0, m = 0; (i & 7) != 7; i++) m++; out[k++] = m; 
#pragma plcxx loop_bound(30000)
for (i = 0, m = 0; i * 3 < 40; i++) m++; out[k++] = m; 
#pragma plcxx loop_bound(30000)
for (i = 100, m = 0; i / 2 > 10; i--) m++; out[k++] = m;
  
#pragma plcxx loop_bound(30000)
for (i = 0, m = 0; (unsigned char) i < 200; i += 50) { m++; if (m > 20) break; } out[k++] = m; out[k++] = i;
  for (i = -5, m = 0; (unsigned) i > 10; i++) m++; out[k++] = m; out[k++] = i;
  for (c = 0, m = 0; c != 200; c += 100) { m++; if (m > 20) break; } out[k++] = m; 
#pragma plcxx loop_bound(30000)
for (s = 100, m = 0; s != -100; s += 8) { m++; if (m > 40) break; } out[k++] = m; out[k++] = s;
  for (u = 60000, m = 0; u > 50000u; u += 1000) m++; out[k++] = m; out[k++] = u; for (l = 70000; l > 65530; l -= 7) m++; out[k++] = m; out[k++] = (int) l;
  i = 10; while (i-- > 3) m++; out[k++] = i; while (++i < 9) m++; out[k++] = i; while (i--) m++; out[k++] = i; out[k++] = m;
  i = 0; do m++; while (i++ < 4); out[k++] = i; do m--; while (--i > 0); out[k++] = i; out[k++] = m; c = 3; do m++; while (c--); out[k++] = c; out[k++] = m;
  
#pragma plcxx loop_bound(30000)
for (i = 0, p = t; p < t + 20; p += 3) { *p = i; i++; } out[k++] = i; out[k++] = p - t; for (i = 19, m = 0; i >= 0; i -= 4) m += t[i] + 1; out[k++] = m;
  
#pragma plcxx loop_bound(30000)
for (i = 0, j = 10; i < j; i++, j--) m++; out[k++] = i + j; for (i = 0, j = 3; j && i < 50; i++) { for (; j < i; j += 2) m++; if (i == 20) j = 0; } out[k++] = i; out[k++] = j; out[k++] = m;
  i = 0; again: i += 3; m += i; if (i < 30) goto again; out[k++] = i; out[k++] = m;
  i = X[2]; again2: if (i > 0) { i--; m += 2; goto again2; } out[k++] = i; out[k++] = m;
  switch (X[1]) { case 0: for (i = 0; i < X[2]; i++) { if (i == 3) continue; m++; } break; case 1: i = 4; while (i) { i--; if (i == 1) break; } break; default: i = 77; } out[k++] = i; out[k++] = m;
  
#pragma plcxx loop_bound(30000)
for (i = 0; i < *F_ui[1] % 20; i++) { switch (i) { case 4: continue; case 9: i = 12; break; default: m++; } } out[k++] = i; out[k++] = m;
}
void plc2() { }
