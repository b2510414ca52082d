// What arguments, returns, casts and conditional expressions convert.
// shows: l long 40
// sets: X[0] 200, P[0] 40000, P[1] 5
// sets: X[0] 127, P[0] 255, P[1] 65535
long l[40];
char to_char(int v) { return v; }
unsigned char to_byte(long v) { return v; }
int to_int(unsigned v) { return v; }
unsigned to_unsigned(char v) { return v; }
long to_long(unsigned char v) { return -v; }
unsigned long to_ulong(int v) { return v; }
short to_short(unsigned long v) { return v + 1; }
signed char nothing(signed char c, unsigned short u, short s) { return c = u -= s; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i = P_i[0]; unsigned u = P[1]; char c = X[0]; unsigned char b = X[0]; long w = P_l[0]; unsigned long ul = w;
  l[k++] = to_char(i); l[k++] = to_byte(i); l[k++] = to_int(w); l[k++] = to_unsigned(b); l[k++] = to_long(c); l[k++] = to_ulong(u); l[k++] = to_short(ul); l[k++] = nothing(b, u, i);
  l[k++] = to_char(-b) * to_byte(-1); l[k++] = to_ulong(-1) > to_long(1); l[k++] = to_int(-1) == to_unsigned(-1); l[k++] = to_unsigned(255) >> 4; l[k++] = -to_byte(1);
  l[k++] = (unsigned char) i; l[k++] = (char) u; l[k++] = (int) (char) b; l[k++] = (unsigned) c; l[k++] = (unsigned long) (unsigned) c; l[k++] = (long) (int) ul; l[k++] = (unsigned char) (char) -1; l[k++] = (int) (unsigned char) c + (char) b;
  l[k++] = i ? c : u; l[k++] = (i ? c : u) < 0; l[k++] = i ? c : ul; l[k++] = (u ? -1 : 0u) > 0; l[k++] = (b ? c : b) * 2; l[k++] = (i > 0 ? i : -1L) / 2; l[k++] = -(u ? b : 1u) / 2;
  l[k++] = (c, u) + i; l[k++] = (b + c) * u; l[k++] = (char) (b + c) * (long) u; l[k++] = b + c + w; l[k++] = (unsigned) b * u * 3L; l[k++] = i * u / 2; l[k++] = i * (long) u / 2; l[k++] = (long) (i * u) / 2;
  l[k++] = !w + !i + !(char) 256 + !(unsigned char) u; l[k++] = (w != 0) + (ul > 0x7FFFFFFF) * 2 + (c != b) * 4; l[k++] = ~(char) u ^ (unsigned char) ~u; l[k++] = -(unsigned char) c % 7;
}
void plc2() { }
