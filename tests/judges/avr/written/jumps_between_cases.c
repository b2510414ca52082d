// gotos between arms, out of nested switches, into following arms, with default in front.
// shows: o int 30
// sets: X[0] 0, X[1] 0
// sets: X[0] 1, X[1] 2
// sets: X[0] 2, X[1] 1
// sets: X[0] 3, X[1] 3
// sets: X[0] 9, X[1] 4
int o[30];
static int arms(int a, int b) { int n = 0; switch (a) { default: n = 1; if (b == 4) goto three; break; case 0: n = 10; if (b) break; goto two; case 1: n = 20; two: n += 2; break; case 2: { n = 30; { if (b == 1) goto out; } } case 3: three: n += 100; switch (b) { case 3: goto out; case 4: n += 1000; break; default: n++; goto two; } n += 7; } n += 10000; out: return n; }
static int nested(int a, int b) { int n = 0; switch (a) { case 0: case 1: switch (b) { case 2: n += 1; if (a) { case 0: n += 2; break; } default: n += 4; } if (n > 3) break; n += 8; /* fall */ case 2: if (b == 1) { case 3: n += 16; } else n += 32; break; case 9: for (n = 0; n < 9; n++) switch (b) { case 4: if (n > 2) goto done; continue; default: goto done; } } n += 64; done: return n; }
static int blocks(int a) { int n = 0; switch (a) { { case 0: n = 1; } { int q; case 1: q = 5; n += q; } break; case 2: ; case 3: { break; } default: { { n = 7; } } } return n; }
static int conds(int a, int b) { int n = 5; switch (a) { case 0: if (b) { n = 1; break; } else { n = 2; } n += 10; break; case 1: while (n > 0) { n--; if (n == b) break; } break; case 2: /*@loop_bound 4*/ do { n += 3; if (b == 1) continue; n++; } while (n < 9); break; case 3: return n * b; } return n; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { int k = 0, a = X[0], b = X[1]; o[k++] = arms(a, b); o[k++] = arms(b, a); o[k++] = nested(a, b); o[k++] = nested(b, a); o[k++] = blocks(a); o[k++] = blocks(b); o[k++] = conds(a, b); o[k++] = conds(b, a); }
void plc2() { }
