// What few programs have: real constants as conditions, constants behind commas, && and || as limits, pointers out of commas, labels in front of labels.
// shows: l long 120
// sets: X[0] 1, X[1] 128, P[0] 256, P[1] 1
// sets: X[0] 0, X[1] 255, P[0] 65535, P[1] 65535
// sets: X[0] 4, X[1] 0, P[0] 0, P[1] 32768
long l[120]; int k, t[8], *g, *h; unsigned char d; float f;
int any() { return X[0] & 3; }
int in_do() { /*@loop_bound 2@*/ do { d++; return 3; } while (X[0]); }
int in_switch() { switch (X[0]) { case 1: switch (X[1]) { case 128: return 1; default: return 2; } case 0: return 3; default: return 4; } }
void reals()
{
  int n = 0, a = X[0], b = P[0];
  f = X[1] / 4;
  if (1.0) n += 1; else n += 2; if (0.5) n += 4; else n += 8; if (0.0) n += 16; else n += 32; if (f) n += 64; if (!f) n += 128; while (0.0) n += 256; do n += 512; while (0.0);
  l[k++] = n; l[k++] = 1.0 && a; l[k++] = 0.5 || a; l[k++] = !1.0 + !0.5 * 2 + !0.0 * 4; l[k++] = 1.0 ? a : b; l[k++] = 0.0 ? a : b; l[k++] = 1.0f && 0.25; l[k++] = f && a; l[k++] = f ? a : b; l[k++] = 0.25 ? f : b;
}
void known_late()
{
  int n = 0, a = 0, b = X[0], five = 5;
  if ((a++, 5)) n += 1; if ((a++, 0)) n += 2; if (five) n += 4; else n += 8; l[k++] = n; n = !(a++, 7); l[k++] = n; n = !(a++, 0); l[k++] = n; n = (a++, 3) && b; l[k++] = n; n = (a++, 0) || b; l[k++] = n; n = (a++, 1) ? a : b; l[k++] = n;
  l[k++] = five && b; l[k++] = !five; five = 0; l[k++] = !five; l[k++] = five || b; l[k++] = a;
}
void limits()
{
  int i, n = 0, a = X[0], b = P[0];
  for (i = 0; i < !a; i++) n++; l[k++] = n; for (i = 0; i < (a && b); i++) n++; l[k++] = n; for (i = 0; i < (a || b); i++) n++; l[k++] = n; for (i = 0; i <= (a || b); i++) n++; l[k++] = n;
  for (i = 3; i > !b; i--) n++; l[k++] = n; for (i = 0; i < -(a && b) + 4; i++) n++; l[k++] = n; for (i = 0; i < (a ? 3 : 5); i++) n++; l[k++] = n; for (i = 0; i < (a > 3 ? a & 7 : 2); i++) n++; l[k++] = n;
  for (d = 0; d < (a || b) + 2; d++) n++; l[k++] = n + d; l[k++] = ((a && b) < 2) + ((a || b) > 1) * 2 + (!a < 2) * 4 + (!a == !b) * 8;
}
void pointing()
{
  int n = 0, *r = t, *s = &t[3], i;
  for (i = 0; i < 8; i++) t[i] = i * 3 + X[0];
  r = (n++, s); l[k++] = *(n++, r); l[k++] = *(any(), r + 1); l[k++] = (any(), s)[2]; r = X[0] ? (n++, s) : t; l[k++] = *r; *(n++, r) = 4; *(n++, r) += 4; (*(n++, r))++; l[k++] = *r;
  g = h = t; l[k++] = g == h; g = (h = &t[2]) + 1; l[k++] = *g * 100 + *h; l[k++] = *(g = t); l[k++] = *(g += 2); l[k++] = *(h -= 1); if ((n++, g)) n += 20; l[k++] = n;
  if (g && *g) n++; i = (n++, g) == h; l[k++] = i; i = (n++, g) != 0; l[k++] = i; r = 0; if (r) n += 100; if (r == 0) n += 200; l[k++] = n; r = t; r++; --s; l[k++] = (s - t) * 10 + (r - t); l[k++] = (s > t) + (s >= r) * 2 + (r < s) * 4 + (&t[X[0] & 7] < s) * 8; l[k++] = &t[X[0] & 7] - s;
}
void given()
{
  const char *names[2] = {"ab", "c"}; char grid[2][3] = {"ab", {1, 2}}, rows[2][2][2] = {{"a"}, {{1}, "b"}}; int w[4] = {X[0], 2, X[1]};
  struct { int x; char text[4]; unsigned low : 3; unsigned high : 5; } s = {X[1], "abc", 5, 17};
  l[k++] = names[X[0] & 1][0]; l[k++] = grid[X[0] & 1][1]; l[k++] = rows[1][1][0] * 100 + rows[0][0][0] + rows[1][0][0] * 7; l[k++] = s.x + s.text[2] * 2 + s.text[3]; l[k++] = s.low * 100 + s.high; l[k++] = w[0] + w[1] * 3 + w[2] * 5 + w[3] * 7;
}
void labels()
{
  int i, n = 0, a = X[0], b = X[1] & 1;
  i = 0; one: two: n++; i++; if (i < 10) goto two; l[k++] = n; i = 0; three: four: n += 2; if (++i < 10) goto three; l[k++] = n;
  switch (a) { case 1: i = 0; five: n++; if (++i < 5) goto five; break; case 4: case 3: six: n--; } l[k++] = n; switch (a) { case 1: seven: i = n; case 4: eight: n -= 3; break; default: n = 0; } l[k++] = n;
  i = 0; nine: { n++; { i++; if (i < 4) goto nine; } } l[k++] = n; i = 0; ten: if (i >= 10) goto end; n++; if (i < 7) { i++; goto ten; } end: n--; l[k++] = n * 100 + i;
  i = 0; again: if (++i < 10) { if (a) goto again; n++; } l[k++] = n * 100 + i; if (a) goto over; else if (b) goto over; n++; over: ; l[k++] = n;
}
void switches()
{
  int n = 0, a = X[0], b = X[1] & 1, c = P[0];
  switch (a) { case 1: if (!b) { switch (c) { case 256: n++; break; default: n--; } case 4: n -= 2; } n += 40; } l[k++] = n; switch (a) { case 1: { switch (b) { case 0: n++; case 2: break; } case 3: n--; break; } case 4: n = 4; } l[k++] = n; switch (a) { case 1: switch (b) { case 0: switch (c) { case 256: n += 9; break; } break; } break; case 0: n = 2; } l[k++] = n;
  l[k++] = in_do(); l[k++] = in_switch(); /*@loop_bound 2@*/ do { n++; break; } while (a); /*@loop_bound 2@*/ do { n++; if (a) break; else break; } while (a); l[k++] = n;
}
void steps()
{
  int i, n = 0;
  for (i = 0; i < 9; i = 1 + i) n++; l[k++] = n; for (i = 0; i < 9; i = i + 2) n++; l[k++] = n; for (i = 9; i > 0; i = i - 2) n++; l[k++] = n; for (i = 9; i > 0; i = -2 + i) n++; l[k++] = n;
  /*@loop_bound 12@*/ for (i = 2; i < 200; i = i * i) n++; l[k++] = n * 1000 + i; /*@loop_bound 12@*/ for (i = 1; i < 300; i += i) n++; l[k++] = n * 1000 + i;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { k = 0; reals(); known_late(); limits(); pointing(); given(); labels(); switches(); steps(); }
void plc2() { }
