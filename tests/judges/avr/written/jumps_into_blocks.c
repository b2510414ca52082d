// gotos into blocks and ifs from outside, from one arm into the other, past initialised variables.
// shows: o int 20
// sets: X[0] 0, X[1] 0
// sets: X[0] 1, X[1] 0
// sets: X[0] 0, X[1] 1
// sets: X[0] 3, X[1] 2
int o[20];
static int f(int a, int b) { int n = 0; if (a == 3) goto mid; if (a) { n += 1; if (b) goto other; mid: n += 2; } else { n += 4; other: n += 8; if (b == 1) goto last; } n += 16; last: return n; }
static int g(int a, int b) { int n = 0; { int q; q = 3; if (a) goto deep; n += q; } { { { n += 10; deep: n += 100; } } n += 1000; } if (b == 2) { if (n < 5000) { n += 5000; } } return n; }
static int h(int a, int b) { int n = a; if (b) goto l; if (a) { n += 10; } else if (b == 1) { n += 20; } else { l: n += 40; if (a > 2) goto m; } n += 80; if (n > 1000) { m: n = -n; } return n; }
static int p(int a, int b) { int n = 0, i = 0; if (a) goto in; while (i < 3) { i++; n += 5; } if (0) { in: n += 7; } if (!b) { if (a) goto z; n += 70; } z: n += 700; return n; }
static int q(int a, int b) { int i, n = 0; for (i = 0; i < 5; i++) { if (i == a) goto x; if (i == b) { n += 10; x: n += 100; } else { n++; } } return n; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { int k = 0, a = X[0], b = X[1]; o[k++] = f(a, b); o[k++] = f(b, a); o[k++] = g(a, b); o[k++] = g(b, a); o[k++] = h(a, b); o[k++] = h(b, a); o[k++] = p(a, b); o[k++] = p(b, a); o[k++] = q(a, b); o[k++] = q(b, a); }
void plc2() { }
