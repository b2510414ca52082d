_FILES_CLASSICLADDER
_FILE-sections.csv
000,0,-1,0,0,0
_/FILE-sections.csv
_FILE-timers_iec.csv
2,2,2
_/FILE-timers_iec.csv
_FILE-rung_0.csv
1-0-50/0 , 99-0-0/0 , 13-0-0/0 , 50-0-60/0
0-0-0/0 , 99-0-0/0 , 99-0-0/0
_/FILE-rung_0.csv
_/FILES_CLASSICLADDER
