// Counted loops of every form, with what their counters are afterwards.
// shows: rounds unsigned 24, after long 24
// sets: X[0] 5, P[0] 9
// sets: X[0] 0, P[0] 0
// sets: X[0] 255, P[0] 12
unsigned rounds[24];
long after[24];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i; unsigned u; char c; unsigned char b; long l; unsigned n = P[0] > 12 ? 12 : P[0];
  for (i = 0; i < 24; i++) rounds[i] = 0;
  for (i = 0; i < 10; i += 3) rounds[0]++;
  after[0] = i;
  for (i = 10; i >= 0; i -= 4) rounds[1]++;
  after[1] = i;
  for (u = 5; u; u--) rounds[2]++;
  after[2] = u;
  for (b = 250; b != 4; b++) rounds[3]++;
  after[3] = b;
  for (c = -100; c <= 60; c += 40) rounds[4]++;
  after[4] = c;
  for (l = 100000; l > 99000; l -= 333) rounds[5]++;
  after[5] = l;
  b = X[0]; while (b--) rounds[6]++;
  after[6] = b;
  b = X[0]; while (--b > 3) rounds[7]++;
  after[7] = b;
  i = 0; do { rounds[8]++; i += 2; } while (i < n);
  after[8] = i;
  u = n; do rounds[9] += u; while (u-- != 0);
  after[9] = u;
  for (i = n; i > 0; --i) { if (i == 3) continue; if (i == X[0]) break; rounds[10] += i; }
  after[10] = i;
  i = 0;
again:
  rounds[11]++;
  if (++i < 7) goto again;
  after[11] = i;
  for (i = 0; ; i++) { rounds[12]++; break; }
  after[12] = i;
  for (i = 0; i < n; i++) for (u = 0; u <= i; u++) { if (u & 1) continue; rounds[13] += u; if (u > 5) goto out; }
out:
  after[13] = i * 100 + u;
  i = 0; while (i < 20) { i++; if (i % 3) continue; rounds[14]++; if (rounds[14] == 4) break; }
  after[14] = i;
  for (b = 0, i = 100; b < 200; b += 50, i -= b) rounds[15] += i;
  after[15] = i + b;
  for (l = 0; l < 5 && X[1] == 0; ++l) ;
  after[16] = l;
  do { rounds[17]++; if (X[0]) break; rounds[17] += 10; } while (0);
}
void plc2() { }
