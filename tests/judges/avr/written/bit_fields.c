// Flags in bit-fields: signed ones, carries out of them, compound assignments, in an array of structs.
// shows: out int 40
// sets: X[0] 5, P[0] 65535
// sets: X[0] 250, P[0] 33000
struct flags { unsigned ready : 1; unsigned mode : 3; int small : 4; unsigned wide : 8; int one : 1; unsigned char tail : 5; unsigned full : 16; };
struct flags f, g[3];
int out[40];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0;
  f.ready = X[0]; f.mode = X[0]; f.small = X[0]; f.wide = P[0]; f.one = X[0]; f.tail = X[0]; f.full = P[0];
  out[i++] = f.ready; out[i++] = f.mode; out[i++] = f.small; out[i++] = f.wide; out[i++] = f.one; out[i++] = f.tail; out[i++] = f.full;
  out[i++] = f.mode - 7; out[i++] = f.mode - 7 < 0; out[i++] = f.full - 1 > 0; out[i++] = f.small > f.mode;
  out[i++] = -f.mode; out[i++] = ~f.ready; out[i++] = !f.one; out[i++] = f.wide << 8; out[i++] = f.small >> 1;
  out[i++] = f.mode++; out[i++] = f.mode += 6; out[i++] = f.small = 9; out[i++] = ++f.small; out[i++] = f.small -= 15; out[i++] = f.one--;
  out[i++] = f.tail *= 7; out[i++] = f.wide /= 3; out[i++] = f.full ^= -1; out[i++] = f.full >>= 3; out[i++] = f.wide <<= 1; out[i++] = f.tail |= 0xF0;
  g[X[0] % 3] = f;
  g[(X[0] + 1) % 3].mode = g[X[0] % 3].tail; g[1].small |= 4; g[0].full += 40000; g[2].one ^= 1;
  out[i++] = g[0].mode; out[i++] = g[1].mode; out[i++] = g[2].mode; out[i++] = g[1].small; out[i++] = g[0].full; out[i++] = g[2].one;
  out[i++] = g[0].full / 2 > 0x4000; out[i++] = (g[0].mode ? g[1].small : g[2].wide) * 2; out[i++] = f.mode == 7 && f.ready;
}
void plc2() { }
