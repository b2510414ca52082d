// More data than there is room for: the largest variable is named, wherever it is declared.
#include "plc.h"
char first[9000], second[20000];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { static char kept[40000]; kept[X[0]] = first[1] + second[2]; }
void plc2() { }
