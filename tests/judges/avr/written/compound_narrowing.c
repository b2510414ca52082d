// The value of an assignment is that of its narrowed left side; chains of assignments through bytes.
// shows: out long 40
// sets: P[0] 1000, X[0] 200
// sets: P[0] 64767, X[0] 129
long out[40];
char c; unsigned char b; int i; unsigned u; long l; unsigned long ul;
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0;
  out[k++] = b = P[0]; out[k++] = c = P[0]; out[k++] = i = c = b = P[0]; out[k++] = l = u = c = X[0]; out[k++] = ul = i = u = P[0];
  out[k++] = b += 300; out[k++] = c -= 1000; out[k++] = b *= c; out[k++] = c *= c; out[k++] = (b = 255) + 1; out[k++] = (b += 1) == 0;
  out[k++] = (c = 127, ++c); out[k++] = c++ + 1; out[k++] = (c = 128) < 0; out[k++] = -(b = 1); out[k++] = ~(b = 0x0F);
  i = P_i[0]; out[k++] = i += 40000L; out[k++] = i -= 3000000000; out[k++] = i *= 3L; out[k++] = i /= 2u; out[k++] = i %= 7L;
  u = P[0]; out[k++] = u += -1; out[k++] = u -= 70000; out[k++] = u *= u; out[k++] = u /= -3L; out[k++] = u >>= 1L; out[k++] = u <<= X[0] & 15;
  l = P_i[0]; out[k++] = l *= l; out[k++] = l -= 65535u; out[k++] = l /= -7; out[k++] = l ^= 0xFFFF; out[k++] = l &= ~0xFF; out[k++] = l |= -128;
  ul = X[0]; out[k++] = ul -= 201; out[k++] = ul /= 3; out[k++] = ul += c; out[k++] = ul *= -1; out[k++] = ul >>= 7; out[k++] = ul %= 1000;
}
void plc2() { }
