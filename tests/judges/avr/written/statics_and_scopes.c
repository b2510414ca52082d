// Static variables of functions, names that hide others, blocks with their own variables, initialisers at each entry.
// shows: out int 16, shared int 1
// sets: X[0] 1
// sets: X[0] 2 cycles 3
// sets: X[0] 3 cycles 2
int out[16], shared = 7;
static int next(void) { static int n = -3; static unsigned char wraps = 254; n += 2; return n * ++wraps; }
static int next_other(int by) { static int n; n += by; { static int n = 100; n -= by; out[0] = n; } return n; }
static void count(int shared) { int i; for (i = 0; i < 3; i++) { int shared = i; shared++; out[1] += shared; } shared += 10; out[2] = shared; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int x = X[0], i;
  out[3] = next(); out[4] += next_other(x); count(x + shared);
  {
    int x = out[3]; { int x = 5; out[5] += x; } out[6] = x; shared += x;
  }
  for (i = 0; i < 4; i++) { int local = i, twice = local * 2; local += x; out[7] += local * twice; { char local = twice + 126; out[8] += local; } }
  out[9] = x;
  if (x) { static int seen; int x = ++seen; out[10] = x; } else { static int seen = 50; out[11] = ++seen; }
}
void plc2() { static int shared = -1; out[12] = shared--; out[13] = next(); }
