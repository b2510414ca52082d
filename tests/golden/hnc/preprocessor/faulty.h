int fine;
int f() { return nowhere; }
