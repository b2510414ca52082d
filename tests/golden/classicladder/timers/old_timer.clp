_FILES_CLASSICLADDER
_FILE-sections.csv
000,0,-1,0,0,0
_/FILE-sections.csv
_FILE-timers.csv
2,3
_/FILE-timers.csv
_FILE-rung_0.csv
1-0-50/0 , 99-0-0/0 , 10-0-0/0 , 50-0-60/0
9-0-0/0 , 99-0-0/0 , 99-0-0/0 , 50-0-60/1
_/FILE-rung_0.csv
_/FILES_CLASSICLADDER
