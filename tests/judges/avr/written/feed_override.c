// Speeds by override switches: 16-bit products that overflow, casts in the right and in the wrong place.
// shows: right long 16, wrong long 16, cut int 16
// sets: P[0] 3000, P[1] 120, P[2] 60000, X[0] 7
// sets: P[0] 65000, P[1] 150, P[2] 5, X[0] 15
const unsigned char per_cent[16] = {0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 95, 100, 105, 110, 120, 150};
long right[16], wrong[16];
int cut[16];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i;
  unsigned vmax = P[0];
  for (i = 0; i < 16; i++) {
    right[i] = (long) vmax * per_cent[i] / 100;
    wrong[i] = vmax * per_cent[i] / 100;
    cut[i] = (int) vmax * per_cent[i] / 100;
    right[i] += (long) (vmax * per_cent[i]);
    wrong[i] -= vmax * (long) P[1] / (per_cent[i] + 1);
    cut[i] -= vmax * P[1] / (per_cent[X[0] & 15] + 1);
    if (right[i] > P[2]) right[i] = P[2];
    if (wrong[i] > (int) P[2]) wrong[i] = (int) P[2];
  }
}
void plc2() { }
