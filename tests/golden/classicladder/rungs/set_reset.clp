_FILES_CLASSICLADDER
_FILE-sections.csv
000,0,-1,0,0,0
_/FILE-sections.csv
_FILE-rung_0.csv
1-0-50/0 , 52-0-60/0
1-0-50/1 , 53-0-60/0
_/FILE-rung_0.csv
_/FILES_CLASSICLADDER
