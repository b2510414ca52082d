// Bit-fields beside the whole numbers of a union: limits, steps, counters, selectors and arms are those of the field, not of its unit.
// shows: out int 48
// sets: X[0] 8, X[1] 0, X[2] 5
// sets: X[0] 23, X[1] 1, X[2] 9
union both { int n; unsigned u; struct { int f : 4; int g : 12; } s; struct { unsigned l : 3; unsigned h : 13; } t; unsigned char b[2]; };
int out[48];
union both held;
int below(int limit) { int i, rounds = 0; for (i = 0; i < limit; i++) { rounds++; if (rounds > 100) break; } return rounds; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  union both u;
  int i, k = 0, m;
  u.n = 8; m = 0;
  for (i = 4; i > u.s.f; i--) m++;
  out[k++] = m; out[k++] = i;
  u.n = 0x0123; m = 0;
  for (i = 0; i < u.s.g; i++) m++;
  out[k++] = m; out[k++] = i;
  u.u = 0x0019; m = 0;
  for (i = 0; i < u.t.l; i++) m++;
  for (i = 0; i < u.t.h; i++) m += 10;
  out[k++] = m;
  held.n = 0x0012; m = 0;
  for (held.s.f = 0, i = 0; i < held.s.g; i++) m++;
  out[k++] = m; out[k++] = held.n;
  u.n = 15;
  out[k++] = u.s.f < 0; out[k++] = u.s.f == 15; out[k++] = u.s.f ? 1 : 2; out[k++] = u.s.f > u.t.l;
  if (u.n == 10) out[k] = 1; else out[k] = u.s.f == 10; k++;
  u.n = X[0];
  if (u.n > 7 && u.n < 9) { out[k++] = u.s.f; out[k++] = u.s.f > 7; m = 0; for (i = 9; i > u.s.f; i--) m++; out[k++] = m; }
  if (u.n >= 16) { out[k++] = u.s.f; out[k++] = u.s.f >= 16; out[k++] = u.s.f == 7 ? u.s.g : -u.s.g; }
  switch (u.s.f) { case -8: out[k++] = u.n; break; case 7: out[k++] = u.n + 1; break; default: out[k++] = 77; }
  switch (u.n) { case 8: out[k++] = u.s.f; m = 0; for (i = 8; i >= u.s.f; i--) m++; out[k++] = m; break; case 23: out[k++] = u.t.l + u.s.f; break; }
  u.s.f = 3; u.s.g = 0;
  if (u.s.f == 3) out[k++] = u.n == 3;
  if (u.s.f != 3) out[k++] = 99; else out[k++] = u.n;
  u.b[0] = 0xF4; u.b[1] = 0;
  for (i = 0, m = 0; i < u.s.f; i++) m++;
  out[k++] = m;
  out[k++] = below(u.s.f); out[k++] = below(u.s.g);
  u.n = 0;
  
#pragma plcxx loop_bound(30000)
for (m = 0; u.n < 6; u.n = u.s.f + 1) m++;
  out[k++] = m;
  u.n = 0;
  
#pragma plcxx loop_bound(30000)
for (m = 0; u.n < 20; u.n = u.s.f + 1) { m++; if (m == 300) break; }
  out[k++] = m; out[k++] = u.n;
  u.n = 40;
  
#pragma plcxx loop_bound(30000)
for (m = 0; u.n > 0; u.n = u.s.g - 1) m++;
  out[k++] = m; out[k++] = u.n;
  out[k++] = u.s.f == -1; out[k++] = u.n < 0;
}
void plc2() { }
