_FILES_CLASSICLADDER
_FILE-sections.csv
000,0,-1,0,0,0
_/FILE-sections.csv
_FILE-counters.csv
3
_/FILE-counters.csv
_FILE-rung_0.csv
1-0-50/0 , 99-0-0/0 , 12-0-0/0 , 50-0-60/0
1-0-50/1 , 99-0-0/0 , 99-0-0/0 , 50-0-60/1
1-0-50/2 , 99-0-0/0 , 99-0-0/0 , 50-0-60/2
1-0-50/3 , 99-0-0/0 , 99-0-0/0
_/FILE-rung_0.csv
_/FILES_CLASSICLADDER
