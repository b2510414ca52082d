// Labels that gotos above and below lead to, in loops, blocks, arms and cases; two at one statement.
// shows: o int 30
// sets: X[0] 0, X[1] 0
// sets: X[0] 1, X[1] 3
// sets: X[0] 2, X[1] 1
// sets: X[0] 5, X[1] 2
int o[30];
static int one(int a, int b) { int n = 0; if (a) goto top; n = 5; top: n++; if (b > 2) goto end; if (n < 4) goto top; end: return n; }
static int two(int a) { int i, s = 0; for (i = 0; i < 3; i++) { int j = 0; if (a == i) goto in; s += 100; in: j++; s++; if (j < 3) goto in; if (a == 5) goto tail; s += 2; tail: ; } return s; }
static int three(int a, int b) { int n = 0; if (a == 1) goto x; if (a == 2) { y: n += 10; goto z; } x: n += 1; if (b) { n += 2; goto y; } z: n += 100; return n; }
static int four(int a) { int n = a, i = 0; if (a & 1) goto l1; l0: l1: i++; n += i; if (i < 2) goto l0; if (i < 4) { if (a & 2) goto done; i++; } done: return n * 10 + i; }
static int five(int a, int b) { int n = 0, i = 0; switch (a) { case 0: goto here; case 1: n = 7; here: i++; n += i; if (i < b) goto here; break; case 2: i = 1; goto after; default: n = -1; } n += 20; after: if (i == 1) goto skip; n += 40; skip: return n; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { int k = 0, a = X[0], b = X[1]; o[k++] = one(a, b); o[k++] = one(b, a); o[k++] = two(a); o[k++] = three(a, b); o[k++] = three(b, a); o[k++] = four(a); o[k++] = four(b); o[k++] = five(a, b); o[k++] = five(b, a); o[k++] = five(1, 3); }
void plc2() { }
