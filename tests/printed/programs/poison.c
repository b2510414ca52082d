// What is wrong is said once, and not again where it is used.
#include "plc.h"
int n, *one, *two, *three, *four, *five_5, *five;
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() {
  one = &missing; n = *one;
  two = 1.5; n = *two;
  three=missing2; n = three[1];
  four == missing3; n = *four;
  five_5 = &missing4; n = *five; n = *five_5;
}
void plc2() { }
