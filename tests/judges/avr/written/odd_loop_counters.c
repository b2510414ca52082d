// What a counter is behind each form of loop, with break, continue, wraps of bytes, and limits that are more than a constant.
// shows: l long 60
// sets: X[0] 3, X[1] 0, P[0] 9
// sets: X[0] 255, X[1] 7, P[0] 0
// sets: X[0] 12, X[1] 3, P[0] 65535
long l[60];
struct { unsigned char n; int m; } s;
union { unsigned u; unsigned char c[2]; } w;
static int calls;
int limit(void) { calls++; return 5; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i, j, n; unsigned u; char c; signed char sc; unsigned char b; long q; unsigned long ul; short h;
  calls = 0;
  for (i = 0; i < (X[0] & 15); i++) if (i == 7) break; l[k++] = i;
  for (i = X[0] & 15; i > 0; i -= 3) ; l[k++] = i;
  for (i = 0, j = 10; i < j; i++) continue; l[k++] = i + j;
  for (i = 0, j = 10; j > 0; i += j, j--) if (j == 4) continue; else i++; l[k++] = i;
  i = X[0] & 7; while (i--) ; l[k++] = i;
  i = X[0] & 7; while (--i > 0) ; l[k++] = i;
  b = X[0] & 7; while (b--) ; l[k++] = b;
  u = X[1]; while (u--) ; l[k++] = u;
  i = 0; do { if (i == 3) continue; } while (++i < 8 && i != (X[0] & 15)); l[k++] = i;
  for (c = 100; c < 120; c += 7) ; l[k++] = c;
  for (sc = -100; sc > -120; sc -= 3) ; l[k++] = sc;
  for (b = 250; b != 5; b++) ; l[k++] = b;
  for (b = 250; b > 7; b += 3) ; l[k++] = b;
  //@loop_bound 9
  for (b = 1; b; b <<= 1) ; l[k++] = b;
  //@loop_bound 20
  for (i = 1; i > 0; i <<= 1) ; l[k++] = i;
  /*@loop_bound 17*/
  for (u = 0x8000; u; u >>= 1) if (u & X[1]) break; l[k++] = u;
  for (q = 70000; q > 69000; q -= 300) ; l[k++] = q;
  //@loop_bound 10
  for (ul = 5; ul < 100000; ul *= 7) ; l[k++] = ul;
  for (h = 0; h <= 20; h += 6) if (h == X[0]) goto found; h = -1;
found:
  l[k++] = h;
  s.n = X[0] & 15; for (i = 0; i < s.n; i++) ; l[k++] = i;
  w.c[1] = 0; w.c[0] = X[0]; for (u = 0; u < w.u; u++) if (u > 20) break; l[k++] = u;
  for (n = 0, i = 0; i < 5; i++) for (j = i; j < 5; j++) { if (j == 3) break; n++; } l[k++] = n * 100 + i * 10 + j;
  for (n = 0, i = 4; i >= 0; i--) for (j = 0; j <= i; j++) { if ((i + j) & 1) continue; n += i * j; } l[k++] = n; l[k++] = i; l[k++] = j;
  for (i = 0; i < 10; ++i) { int i = 3; k += i - 3; } l[k++] = i;
  i = 0;
  //@loop_bound 7
  while (1) { if (++i >= 6) break; } l[k++] = i;
  i = 20;
  //@loop_bound 4
  for (;;) { i -= 7; if (i < 0) break; } l[k++] = i;
  i = 10; do i -= 3; while (i > 0); l[k++] = i;
  for (i = 0; i < 4; i++) { s.m = i; } l[k++] = s.m + i;
  for (i = 0, u = P[0]; u && i < 16; u &= u - 1) i++; l[k++] = i;
  for (i = 0; i < 20 && R[i] == 0; i++) ; l[k++] = i; R[5] = X[1]; R[0] = 0;
  for (i = 30; i-- > 10;) if (i == X[0]) break; l[k++] = i;
  for (n = 0, i = -5; i <= 5; i += 2) n = n * 3 + i; l[k++] = n;
  for (i = 0, j = 0; i < 3; i++) { for (; j < 10; j++) if (j % 4 == 3) break; } l[k++] = j;
  j = limit(); for (i = 0; i < j; i++) ; l[k++] = i + calls;
  i = 5; again: if (--i > 1) goto again; l[k++] = i;
  for (b = 0; b < 255; b++) if (b == X[0]) break; l[k++] = b;
  for (b = 255; b > 0; b--) if (b == X[0]) break; l[k++] = b;
  for (c = -128; c < 127; c++) if (c == (char) X[0]) break; l[k++] = c;
  for (u = 65535; u > 65000; u -= 100) ; l[k++] = u;
  for (i = 32760; i < 32767; i++) ; l[k++] = i;
  for (i = -32760; i > -32767; i--) ; l[k++] = i;
}
void plc2() { }
