// Labels that are jumped back to within loops and within each other: each round of a loop begins their count anew.
// shows: counts unsigned 8, path unsigned char 24, at unsigned char 1
// sets: X[0] 2, X[1] 5
// sets: X[0] 0, X[1] 0 cycles 2
// sets: X[0] 9, X[1] 3
// sets: X[0] 255, X[1] 255 cycles 2
unsigned counts[8];
unsigned char path[24], at;
static void step(unsigned char what)
{
  path[at % 24] = what;
  at++;
}
void init() { plc1_time = 1; plc2_time = 2; }
void plc1()
{
  unsigned char i, k, n;
  for (i = 0; i < 3; i++) {
    k = 0;
again:
    counts[0]++;
    step(i * 16 + k);
    k++;
    if (k < (X[0] & 3)) goto again;
    n = 0;
outer:
    k = 0;
inner:
    counts[1]++;
    if (++k < 3) goto inner;
    counts[2] += n;
    if (++n < 4) goto outer;
    if (X[1] & 1 << i) goto next;
    counts[3]++;
next:;
  }
  n = 0;
  while (n < 2) {
    for (k = 5; k > 0; k--) {
      i = 0;
more:
      i++;
      if (i < k) goto more;
      counts[4] += i;
      if (counts[4] & 1) continue;
      counts[5]++;
    }
    n++;
  }
}
void plc2()
{
  unsigned char k = 10;
down:
  counts[6] += k;
  if (X[1] > 4 && k == 6) goto out;
  if (--k) goto down;
  counts[7]++;
out:
  step(k);
}
