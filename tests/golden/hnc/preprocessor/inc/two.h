#define TWO 2
#include "Three.h"
