// M, S, T handlers of a channel, with a wait over scans, and what the control does with their words.
// shows: calls unsigned char 4, station int 1
// sets: F[163] 256, F[164] 3
// sets: F[163] 0
// sets: F[163] 1792, F[164] 1, F[165] 303, F[167] 65036 cycles 3
// sets: F[163] 9472, F[165] 705 cycles 2
// sets: F[163] 1280 cycles 4
// sets: F[163] 33024
unsigned char calls[4];
int station;
void m_code(int ch) { calls[0]++; if (mod_M_code(ch) == 3) { *G_ui[162] |= 0x20; mod_M_code(ch) = -1; } else if (calls[0] % 3 == 0) mod_M_code(ch) = -1; }
void s_code(int ch) { int v = mod_S_code(ch); calls[1]++; *G_i[167] = v < 0 ? -v / 2 : v; mod_S_code(ch) = -1; }
void t_code(int ch)
{
  static unsigned char wait;
  calls[2]++;
  if (!wait) { station = mod_T_code(ch) / 100; wait = mod_T_code(ch) % 100; }
  else if (--wait == 0 || calls[2] > 9) { wait = 0; mod_T_code(ch) = -1; }
}
void init() { plc1_time = 1; plc2_time = 1; set_mst_func(0, 'M', m_code); set_mst_func(0, 'S', &s_code); set_mst_func(0, 'T', t_code); }
void plc1() { if (mod_T_code(0) != -1) calls[3]++; }
void plc2() { }
