// A turret of 12 stations: the shorter way to the station that is asked for, as programs for such machines compute it.
// shows: out int 20, way char 20, steps unsigned char 20
// sets: X[0] 3, X[1] 11
// sets: X[0] 12, X[1] 1
// sets: X[0] 0, X[1] 255
#define STATIONS 12
#define WRAP(n) ((n) < 0 ? (n) + STATIONS : (n) >= STATIONS ? (n) - STATIONS : (n))
int out[20];
char way[20];
unsigned char steps[20];

static char shorter(from, to)
int from;
int to;
{
  int d = to - from;
  d = WRAP(d);
  return d == 0 ? 0 : d <= STATIONS / 2 ? 1 : -1;
}

static unsigned char distance(unsigned char from, unsigned char to)
{
  unsigned char d;
  d = to - from;
  if (d > 127) d += STATIONS;
  return d > STATIONS / 2 ? STATIONS - d : d;
}

void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i;
  for (i = 0; i < 20; i++) {
    int a = (X[0] + i) % STATIONS, b = (X[1] * i + 5) % STATIONS;
    way[i] = shorter(a, b);
    steps[i] = distance(a, b);
    out[i] = way[i] * steps[i] - (X[0] - X[1]);
  }
}
void plc2() { Y[0] = way[3]; Y_i[1] = way[4]; Y_ul[1] = (unsigned long) way[1]; }
