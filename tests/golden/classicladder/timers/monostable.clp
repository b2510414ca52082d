_FILES_CLASSICLADDER
_FILE-sections.csv
000,0,-1,0,0,0
_/FILE-sections.csv
_FILE-monostables.csv
2,2
_/FILE-monostables.csv
_FILE-rung_0.csv
1-0-50/0 , 99-0-0/0 , 11-0-0/0 , 50-0-60/0
0-0-0/0 , 99-0-0/0 , 99-0-0/0
_/FILE-rung_0.csv
_/FILES_CLASSICLADDER
