// Switches in unusual shapes: nested, in loops, of every selector type, default anywhere, declarations and gotos in them.
// shows: l long 60
// sets: X[0] 3, X[1] 200, P[0] 65535, P[1] 1
// sets: X[0] 0, X[1] 127, P[0] 32768, P[1] 7
// sets: X[0] 7, X[1] 255, P[0] 3, P[1] 65535
long l[60];
int middle(int v) { int r = 0; switch (v) { case 1: r += 1; default: r += 10; case 2: r += 100; break; case 3: r += 1000; } return r; }
int only_default(int v) { switch (v) default: return 5; return 6; }
int one_label(int v) { switch (v) case 3: v += 100; return v; }
int empty(int v) { switch (v++) { } return v; }
int of_char(char c) { switch (c) { case -1: return 1; case 'a': return 2; case -128: return 3; case 127: return 4; } return 0; }
int of_byte(unsigned char c) { switch (c) { case 255: return 1; case 200: return 2; case 0: return 3; default: break; } return 9; }
int of_unsigned(unsigned u) { switch (u) { case 0xFFFF: return 1; case 0x8000: return 2; case 3: return 3; } return 0; }
int of_unsigned_minus(unsigned u) { switch (u) { case -1: return 1; case -32767 - 1: return 2; } return 0; }
int of_long(long v) { switch (v) { case -1: return 1; case 0x8000: return 2; case 65535: return 3; case 65535L * 65536: return 4; case 7 * 65536 + 32768: return 5; } return 0; }
int of_ulong(unsigned long v) { switch (v) { case 0xFFFFFFFF: return 1; case 0x1FFFF: return 2; default: return 4; case 0x78000: return 3; } }
int nested(int a, int b)
{
  int r = 0;
  switch (a & 3) {
  case 0:
    switch (b) { case 0: r = 1; break; case 1: r = 2; default: r += 4; }
    r += 10;
    break;
  case 3:
    switch (b) { default: switch (a) { case 3: r = 7; break; case 7: return -7; } r += 20; break; case 255: r = 9; }
  case 1:
    r += 30;
  }
  return r;
}
int in_loop(int n)
{
  int i, r = 0;
  for (i = 0; i < 10; i++) {
    switch (i & n) {
    case 0: continue;
    case 1: r += 1; break;
    case 2: r += 10;
    case 3: r += 100; if (i > 6) goto out; continue;
    default: { int i = 3; r += i; } break;
    }
    r += 1000;
  }
out:
  return r + i;
}
int scopes(int v)
{
  int r = 1;
  switch (v) { int q; case 3: q = 5; r = q + v; { case 0: r++; } if (v) { case 7: r += 2; } else r = -r; break; }
  return r;
}
int effects(int v) { int n = 0; switch (n++, v += n, v & 7) { case 4: n += 10; case 1: n += 100; break; case 0: n = 3; } return n * 1000 + v; }
int of_logic(int v) { switch (v > 3 && v != 5) { case 0: return 1; case 1: return 2; } return 3; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i;
  for (i = 0; i < 5; i++) l[k++] = middle(i);
  l[k++] = only_default(X[0]); l[k++] = one_label(X[0]); l[k++] = empty(X[0]);
  l[k++] = of_char(X[1]); l[k++] = of_char(P[0]); l[k++] = of_char('a'); l[k++] = of_char(128); l[k++] = of_byte(X[1]); l[k++] = of_byte(P[0]); l[k++] = of_byte(-56);
  l[k++] = of_unsigned(P[0]); l[k++] = of_unsigned_minus(P[0]); l[k++] = of_long(P[0]); l[k++] = of_long(P_l[0]); l[k++] = of_long(P_i[0]); l[k++] = of_ulong(P_l[0]); l[k++] = of_ulong(P_i[0]);
  l[k++] = nested(X[0], 0); l[k++] = nested(X[0], 1); l[k++] = nested(X[0], X[1]);
  l[k++] = in_loop(X[0]); l[k++] = in_loop(3); l[k++] = in_loop(7); l[k++] = scopes(X[0]); l[k++] = scopes(7); l[k++] = effects(X[0]); l[k++] = of_logic(X[0]); l[k++] = of_logic(5);
}
void plc2() { }
