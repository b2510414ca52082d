// A ring of events with indices that wrap in bytes, as an array of structs, filled and emptied at two rates.
// shows: got int 16, dropped unsigned 1, head unsigned char 1, tail unsigned char 1
// sets: X[0] 5 cycles 3
// sets: X[0] 250 cycles 7
// sets: X[0] 0 cycles 9
#define SIZE 8
#define NEXT(i) ((i) + 1 & SIZE - 1)
typedef struct event { unsigned char code; int value; } event;
static event ring[SIZE];
unsigned char head, tail;
unsigned dropped;
int got[16];
int put(event e) { if (NEXT(head) == tail) { dropped++; return 0; } ring[head] = e; head = NEXT(head); return 1; }
event take(void) { event none; if (head == tail) { none.code = 255; none.value = -1; return none; } none = ring[tail]; tail = NEXT(tail); return none; }
event make(unsigned char code, int value) { event e; e.code = code; e.value = value * code; return e; }
void init() { plc1_time = 1; plc2_time = 3; }
void plc1() { static unsigned char n; if (put(make(X[0] + n, n))) n += 7; else n -= 3; if (n % 5 == 0) put(make(n, -1)); }
void plc2()
{
  static unsigned char at;
  int i;
  for (i = 0; i < 2; i++) {
    event e = take();
    if (e.code == 255) continue;
    got[at++ % 16] = e.value + e.code;
    got[at % 16] ^= take().code;
  }
}
