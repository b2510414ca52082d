// CRC-16, parity, reversed bits: shifts of bytes that are promoted, and truncated again.
// shows: crc unsigned 8, even unsigned char 16, turned unsigned char 16, longs unsigned long 8
// sets: X[0] 49, X[1] 50, X[2] 51, X[3] 255
// sets: X[0] 128, X[1] 1, X[2] 127, X[3] 254
unsigned crc[8];
unsigned char even[16], turned[16];
unsigned long longs[8];

unsigned crc16(unsigned char *p, unsigned char n)
{
  unsigned c = 0xFFFF;
  unsigned char k;
  while (n--) {
    c ^= *p++;
    for (k = 8; k; k--)
      if (c & 1) c = c >> 1 ^ 0xA001; else c >>= 1;
  }
  return c;
}
unsigned ccitt(unsigned char b, unsigned c)
{
  int k;
  c ^= b << 8;
  for (k = 0; k < 8; ++k) c = c & 0x8000 ? c << 1 ^ 0x1021 : c << 1;
  return c;
}
unsigned long crc32(unsigned long c, unsigned char b)
{
  char k;
  c = ~c ^ b;
  for (k = 7; k >= 0; k--) c = c >> 1 ^ (0xEDB88320 & -(c & 1));
  return ~c;
}
unsigned char parity(unsigned char b) { b ^= b >> 4; b ^= b << 2; b ^= b >> 1; return b >> 2 & 1; }
unsigned char reversed(unsigned char b)
{
  b = (b & 0xF0) >> 4 | b << 4;
  b = (b & 0xCC) >> 2 | (b & 0x33) << 2;
  return (b & 0xAA) >> 1 | (b & 0x55) << 1;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  unsigned char i;
  crc[0] = crc16(X, 9);
  crc[1] = crc16(&X[1], 3);
  crc[2] = ccitt(X[0], crc[0]);
  crc[3] = ccitt(X_c[3], ~crc[1]);
  crc[4] = ccitt(-1, -1);
  for (i = 0; i < 16; i++) {
    even[i] = parity(X[i % 4] + i);
    turned[i] = reversed(X[i & 3] ^ i);
  }
  for (i = 0; i < 8; i++) longs[i] = crc32(longs[i], X[i % 4]);
}
void plc2() { }
