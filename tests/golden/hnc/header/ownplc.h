extern unsigned char X_uc[], Y[];
extern unsigned *F_ui[];
extern unsigned plc1_time, plc2_time;
void set_axis_jog(int axis, int speed);
