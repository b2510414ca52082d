// The types of constants: octal, hexadecimal, suffixes, and what becomes of them when they are negated, shifted, compared.
// shows: out long 48, size unsigned char 24
// sets: X[0] 1
long out[48];
unsigned char size[24];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0, k = 0, one = X[0];
  out[i++] = 32767 + one; out[i++] = 32768 + one; out[i++] = 0x7FFF + one; out[i++] = 0x8000 + one; out[i++] = 0xFFFF + one; out[i++] = 65535 + one;
  out[i++] = 0x10000 + one; out[i++] = 077777 + one; out[i++] = 0100000 + one; out[i++] = 0177777 + one; out[i++] = 65535u + one; out[i++] = 40000u * 2;
  out[i++] = -32768; out[i++] = -32768 - one; out[i++] = -0x8000; out[i++] = -0x8000 - one; out[i++] = -32767 - 1 - one; out[i++] = ~0; out[i++] = ~0u; out[i++] = ~0x8000;
  out[i++] = 0x8000 < 0; out[i++] = 32768 > -1; out[i++] = 0x8000 > -1; out[i++] = 0xFFFF == -1; out[i++] = 65535 == -1; out[i++] = 0xFFFFFFFF == -1; out[i++] = 4294967295 > -1;
  out[i++] = 1 << 15; out[i++] = 1u << 15; out[i++] = 1L << 15; out[i++] = 0x4000 << 1; out[i++] = -1 >> 1; out[i++] = 0xFFFF >> 1; out[i++] = 0x8000 / 2; out[i++] = -32768 / 2;
  out[i++] = 200 * 200; out[i++] = 200 * 200L; out[i++] = 200u * 400; out[i++] = 100 * 100 * 100; out[i++] = 30000 + 30000; out[i++] = 2147483647 + one; out[i++] = 0x80000000 + one;
  out[i++] = '\xff'; out[i++] = 'a' * 256; out[i++] = 3000000000 / 3; out[i++] = -3000000000 / 3; out[i++] = 0x7FFFFFFF * 2L; out[i++] = (unsigned char) -1 << 8;
  size[k++] = sizeof 1; size[k++] = sizeof 32768; size[k++] = sizeof 0x8000; size[k++] = sizeof 0x10000; size[k++] = sizeof 'a'; size[k++] = sizeof(char); size[k++] = sizeof "abc";
  size[k++] = sizeof 1L; size[k++] = sizeof(1 << 20L); size[k++] = sizeof(1L << 2); size[k++] = sizeof((char) 1); size[k++] = sizeof((char) 1 + (char) 1); size[k++] = sizeof(1 ? 1 : 1L);
  size[k++] = sizeof(1u == 2L); size[k++] = sizeof(1, 2L); size[k++] = sizeof(short); size[k++] = sizeof out / sizeof *out; size[k++] = sizeof(int[3]); size[k++] = sizeof 1 + 1; size[k++] = sizeof(int) * 2;
  size[k++] = sizeof -1; size[k++] = sizeof !1L; size[k++] = sizeof(long) - sizeof(char) * 5 > 0;
}
void plc2() { }
