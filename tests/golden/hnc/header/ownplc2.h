extern int Y[];
