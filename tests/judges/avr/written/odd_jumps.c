// goto forwards, out of nests, past declarations, between branches, backwards with a counter; labels and variables of one name.
// shows: l long 30
// sets: X[0] 5, X[1] 2
// sets: X[0] 0, X[1] 255
// sets: X[0] 9, X[1] 9
long l[30];
int skip(int v) { int r = 1; if (v > 4) goto end; r = 2; if (v) goto middle; r += 10; middle: r += 100; end: return r; }
int nest(int v) { int i, j, r = 0; for (i = 0; i < 5; i++) { for (j = 0; j < 5; j++) { if (i * j == v) goto out; if (i + j > 6) goto next; r++; } next: ; } r += 1000; out: return r * 100 + i * 10 + j; }
int count(int v) { int n = 0, r = 0; again: r += n * v; if (n++ < 4) goto again; return r * 10 + n; }
int two(int v) { int i = 0, r = 0; a: i++; if (i < v % 7) { r += i; goto a; } b: i--; if (i > 0) goto b; return r * 10 + i; }
int into(int v) { int r = 0; if (v > 4) { r = 1; goto same; } else if (v) { r = 2; same: r += 10; } else r = 3; return r; }
int name(int v) { int v2 = v; if (v2) goto v; v2 = 7; v: return v2; }
int past(int v) { int r = v; if (v) goto done; { int q = 5; r += q; } done: { int q = 6; r += q; } return r; }
int last(int v) { if (v) { v = 3; goto e; } v = 4; e: ; return v; }
int states(int v) { int n = 0, s = 0; next: switch (s) { case 0: s = v > 3 ? 2 : 1; break; case 1: s = 3; break; case 2: s = 1; break; case 3: goto stop; } if (++n < 20) goto next; stop: return n * 10 + s; }
int loops(int v) { int i, n = 0; for (i = 0; i < 8; i++) { if (i == v) goto rest; if (i & 1) continue; n += i; rest: n += 100; } return n; }
int past_label(int c) { int x, i = 0, r = 0; x = 5; if (c) { x = 7; goto mid; } x = 5; again: if (x == 5) r += 1; else r += 100; mid: r += 10; i++; if (i < 3) goto again; return r; }
int from_arm(int v) { int r = 0; if (v > 3) { r = 5;
  //@loop_bound 2
  again: if (v > 2) r += 1; else r += 2; } else { r = 10; goto again; } return r; }
int after_arm(int v) { int r = 0, i = 0; if (v > 3) { i = 1;
  //@loop_bound 5
  again: r += v > 2 ? 1 : 20; } if (++i < 4) goto again; return r * 10 + i; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0;
  l[k++] = skip(X[0]); l[k++] = skip(1); l[k++] = nest(X[0]); l[k++] = nest(X[1]); l[k++] = count(X[1]); l[k++] = two(X[0]); l[k++] = into(X[0]); l[k++] = into(2); l[k++] = name(X[0]); l[k++] = past(X[0]); l[k++] = last(X[0]); l[k++] = states(X[0]); l[k++] = states(1); l[k++] = loops(X[0]); l[k++] = loops(3); l[k++] = past_label(X[0]); l[k++] = past_label(0); l[k++] = from_arm(X[0]); l[k++] = from_arm(3); l[k++] = after_arm(X[0]); l[k++] = after_arm(2);
  if (X[0]) goto x; l[k++] = 1; x: l[k++] = 2; if (X[1] > 5) goto y; l[k++] = 3; y: l[k++] = 4;
}
void plc2() { }
