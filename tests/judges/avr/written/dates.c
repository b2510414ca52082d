// Dates, hours of operation and service intervals in unsigned long, with divisions that carry.
// shows: out long 16, day unsigned char 3, hours unsigned long 1
// sets: P[0] 36524, P[1] 86, X[0] 29
// sets: P[0] 65535, P[1] 40000, X[0] 255 cycles 3
const unsigned char in_month[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
long out[16];
unsigned char day[3];
unsigned long hours = 4294967290;
int is_leap(unsigned y) { return y % 4 == 0 && (y % 100 != 0 || y % 400 == 0); }
unsigned days_of(unsigned y) { return is_leap(y) ? 366 : 365; }
long number(int y, char m, unsigned char d) { long n = (y - 1900) * 365L + (y - 1901) / 4; char k; for (k = 0; k < 12; k++) { if (k + 1 >= m) break; n += in_month[k]; if (k == 1) n += is_leap(y); } return n + d; }
void calendar(unsigned n)
{
  unsigned y = 1900; unsigned char m;
  //@loop_bound 200
  while (n >= days_of(y)) n -= days_of(y++);
  for (m = 0; m < 12; m++) { unsigned char d = in_month[m] + (m == 1 && is_leap(y)); if (n < d) break; n -= d; }
  day[0] = n + 1; day[1] = m + 1; day[2] = y - 1900;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0;
  unsigned long s = (unsigned long) P[0] * P[1];
  calendar(P[0]); hours += X[0];
  out[k++] = s / 3600; out[k++] = s / 60 % 60; out[k++] = s % 60; out[k++] = s / 86400 * -1; out[k++] = number(1900 + day[2], day[1], day[0]) - P[0]; out[k++] = number(2000, 2, X[0]) % 7; out[k++] = hours / 24 % 365; out[k++] = hours > 100000;
  out[k++] = (hours - 5000) / 1000 * 1000 == hours; out[k++] = (long) hours / 24; out[k++] = (long) (hours - X[0]) < 0; out[k++] = P[0] * P[1] / 3600u; out[k++] = P_i[0] * P_i[1] % 60; out[k++] = days_of(P[0]) - is_leap(P[1]) * 365;
}
void plc2() { }
