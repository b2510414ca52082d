// Exits above their errors, retries with a bound, cleanup ladders, jumps from nested blocks to the front.
// shows: o int 30
// sets: X[0] 0, X[1] 0
// sets: X[0] 1, X[1] 3
// sets: X[0] 2, X[1] 9
// sets: X[0] 3, X[1] 200
int o[30]; static int tries, cleaned;
static int open_(int v) { tries++; return v > tries; }
static int ladder(int a, int b) { int r = 1; if (a == 0) goto e0; r += 10; if (b == 0) goto e1; r += 100; if (a + b > 50) goto e2; return r; e2: cleaned += 4; e1: cleaned += 2; e0: cleaned += 1; return -r; }
static int above(int a, int b) { int r = a * 2; goto begin; fail: r = -r; leave: return r + 1; begin: if (a > 2) goto fail; if (b > 2) { r += b; if (b > 100) goto fail; goto leave; } { int q = b; if (q) goto leave; } r = 99; goto leave; }
static int retry(int v) { int n = 0; tries = 0;
/*@loop_bound 5*/
again: n++; if (open_(v)) goto again; return n * 10 + tries; }
static int mixed(int a, int b) { int i, j, s = 0; for (i = 0; i < 4; i++) { for (j = 0; j < 4; j++) { if (i * j == b) goto hit; if (j > a) goto cont; s++; } s += 10; cont: continue; } s = -s; fin: return s; hit: s += 1000; if (a) goto fin; s += 1000; goto fin; }
static int loopback(int a) { int r = 0, n = 0; start: r += 3; n++; if (n == 1 && a > 5) goto other; if (n < 3) goto start; return r; other: r += 50; return r - n; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { int k = 0, a = X[0], b = X[1]; o[k++] = ladder(a, b); o[k++] = ladder(b, a); o[k++] = cleaned; o[k++] = above(a, b); o[k++] = above(b, a); o[k++] = retry(a); o[k++] = mixed(a, b); o[k++] = mixed(b, 9); o[k++] = loopback(a); o[k++] = loopback(b); cleaned = 0; }
void plc2() { }
