// Stores before calls of functions that write and read overlapping bytes.
// shows: a char 1, c char 1, n int 1, w.l long 1
// sets: X[0] 0
// sets: X[0] 1 cycles 2
char a = 100, c = 3;
union { long l; int i[2]; unsigned char b[4]; } w;
int n;
static void clear(int by) {
    w.l = 0;
    if (by > n) n++;
    w.i[1] += by;
}
static int high(int by) {
    n += by;
    if (w.i[1] > 3 && n > by) n -= 2; else if (w.i[0] == by) n ^= 5;
    return w.i[1] > 3 ? w.i[0] : w.b[3];
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() {
    clear(2);
    a >>= 5;
    c = a + 3;
    a++;
    clear(n);
    w.b[3] = 7;
    w.i[0] = 600;
    n += high(1);
    w.b[2] = n;
    n += high(2);
    clear(high(a) + high(c));
}
void plc2() { a ^= 8; clear(5); w.b[3] = a; c += high(3); clear(high(7)); }
