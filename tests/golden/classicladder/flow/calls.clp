_FILES_CLASSICLADDER
_FILE-sections.csv
#VER=1.0
#NAME000=main
#NAME001=count
000,0,-1,0,0,0
001,0,3,4,4,0
_/FILE-sections.csv
_FILE-arithmetic_expressions.csv
#VER=2.0
0000,@200/0@:=@200/0@+1
_/FILE-arithmetic_expressions.csv
_FILE-rung_0.csv
1-0-50/0 , 55-0-0/3
9-0-0/0 , 55-0-0/9
_/FILE-rung_0.csv
_FILE-rung_4.csv
9-0-0/0 , 99-0-0/0 , 99-0-0/0 , 60-0-0/0
_/FILE-rung_4.csv
_/FILES_CLASSICLADDER
