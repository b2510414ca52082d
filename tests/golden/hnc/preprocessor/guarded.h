#ifndef GUARDED_H
#define GUARDED_H
int five = 5;
#endif
