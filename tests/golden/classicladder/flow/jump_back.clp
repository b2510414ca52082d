_FILES_CLASSICLADDER
_FILE-sections.csv
000,0,-1,0,1,0
_/FILE-sections.csv
_FILE-arithmetic_expressions.csv
#VER=2.0
0000,@200/0@:=@200/0@+1
0001,@200/0@<4
_/FILE-arithmetic_expressions.csv
_FILE-rung_0.csv
#NEXTRUNG=1
9-0-0/0 , 99-0-0/0 , 99-0-0/0 , 60-0-0/0
_/FILE-rung_0.csv
_FILE-rung_1.csv
99-0-0/0 , 99-0-0/0 , 20-0-0/1 , 54-0-0/0
_/FILE-rung_1.csv
_/FILES_CLASSICLADDER
