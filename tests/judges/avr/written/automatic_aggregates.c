// Arrays, structures and bit-fields of a function, which their initialisers fill anew in each round and each call.
// shows: trace unsigned 16, text unsigned char 8, sums int 6, rounds unsigned char 1
// sets: X[0] 3, X[1] 200
// sets: X[0] 0, X[1] 7 cycles 2
// sets: X[0] 255, X[1] 129 cycles 3
#define COUNT(a) (sizeof a / sizeof a[0])
struct flags { unsigned char low : 3; unsigned char mid : 4; unsigned char top : 1; int whole; };
struct part { unsigned char name[5]; int size; struct flags f; unsigned char tail[3]; };
unsigned trace[16];
unsigned char text[8], rounds;
int sums[6];
static struct part made(unsigned char c, int n)
{
  struct part p = { { 'a', 'b' }, 0, { 5, 9 }, { 1 } };
  if (n == 0) { struct part none = { "none" }; return none; }
  if (n & 1) p.name[2] = c;
  p.size = n;
  p.f.whole += n - 1;
  p.tail[n & 1] += c;
  return p;
}
static int sum_of(struct part p)
{
  int k, all = p.size + p.f.low + p.f.mid * 2 + p.f.top * 4 + p.f.whole;
  for (k = 0; k < 5; k++) all += p.name[k];
  for (k = 0; k < 3; k++) all ^= p.tail[k] << k;
  p.size = 0;
  p.tail[0] = 0;
  return all;
}
void init() { plc1_time = 1; plc2_time = 2; }
void plc1()
{
  int i;
  for (i = 0; i < 6; i++) {
    unsigned char letters[8] = "xyz";
    int few[4] = { 1, X[0], -3 };
    struct flags f = { 7, 15, 1, 100 }, g = { 0 };
    struct { struct flags each[2]; int n; } both = { { { 1, 2, 0, 3 }, { 4 } }, X[1] };
    struct part got;
    letters[i & 7] += i;
    few[3] += i + 1;
    few[0] += few[3];
    f.low += i;
    f.mid -= i * 3;
    f.top = i;
    g.mid = f.low + f.mid;
    both.each[1].whole += i;
    both.each[0].low -= 2;
    got = made(X[0] + i, i - 2);
    sums[i] = sum_of(got) + few[0] * 3 + few[1] + few[2] + letters[2] + letters[3] + letters[7];
    sums[i] += f.low + f.mid * 8 + f.top * 128 + g.low + g.mid + g.whole + f.whole;
    trace[i] = both.n + both.each[0].low * 16 + both.each[0].whole + both.each[1].whole + both.each[1].low;
    trace[i + 6] = got.size ^ got.tail[0] ^ (got.tail[1] << 4) ^ (got.name[2] << 8);
    text[i] = i & 1 ? letters[i] : got.name[i % 5];
    if (X[0] & 1 << i) continue;
    { unsigned long wide[3] = { 0x10001uL * X[1], i }; wide[2] -= wide[0] + wide[1]; trace[12] ^= wide[2]; trace[13] += wide[2] >> 16; }
  }
  rounds += (i, COUNT(sums));
  i > 5 ? (void)(text[7] = 9) : (void)(text[7] = 1);
}
void plc2()
{
  switch (X[1]) {
    unsigned char kept;
    kept = 77;
  case 7: kept = 3; text[6] = kept; break;
  case 200: trace[15]++;
  }
}
