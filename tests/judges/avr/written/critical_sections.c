// Interrupts off and on again, macros with asm, labels at ends, blocks in blocks, empty statements, nested loops left by goto.
// shows: out int 12
// sets: X[0] 4
// sets: X[0] 77
#ifdef __PLCXX__
#define DI asm cli
#define EI asm sti;
#else
#define DI
#define EI
#endif
int out[12];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i, j, k = 0;
  DI
  out[0]++;
  EI
  ;;; {} { ; { out[1] += X[0]; } }
  for (i = 0; i < 9; i++) {
    for (j = 0; j < 9; j++) { if (i * j == (X[0] & 31)) goto found; if (j > i) goto next; k++; }
  next:
    k += 100;
  }
  out[2] = -1; goto done;
found: out[2] = i * 10 + j;
done:
  out[3] = k;
  if (X[0] & 1) if (X[0] & 2) out[4] = 1; else out[4] = 2;
  if (X[0] & 4) { if (X[0] & 8) out[5] = 1; } else out[5] = 2;
  if (out[4]) ; else out[6]++;
  i = 0;
back:
  i += 2; switch (i) { case 4: out[7]++; goto back2; case 8: break; default: out[8] += i; } out[9] = i;
back2:
  if (i < 10) goto back;
  for (i = 5; i--; ) { if (i == 2) continue; out[10] = out[10] * 3 + i; }
  do { if (++k & 1) continue; out[11] += k; break; } while (0);
}
void plc2() { }
