_FILES_CLASSICLADDER
_FILE-sections.csv
#VER=1.0
#NAME000=Page
#NAME001=Outputs
000,1,-1,0,0,0
001,0,-1,0,0,0
_/FILE-sections.csv
_FILE-general.txt
SIZE_NBR_PHYS_INPUTS=4
SIZE_NBR_PHYS_OUTPUTS=4
_/FILE-general.txt
_FILE-sequential.csv
#VER=1.0
S0,1,1,0,1,1
S1,0,2,0,1,3
S2,0,3,0,1,5
T0,1,-1,-1,-1,-1,-1,-1,-1,-1,-1,0,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,0,1,2
T1,2,-1,-1,-1,-1,-1,-1,-1,-1,-1,1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,0,1,4
T2,0,-1,-1,-1,-1,-1,-1,-1,-1,-1,2,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,0,1,6
C0,0,50/0
C1,0,50/1
C2,0,50/2
_/FILE-sequential.csv
_FILE-rung_0.csv
#VER=2.0
#LABEL=OUT
#COMMENT=of the steps
#PREVRUNG=-1
#NEXTRUNG=-1
1-0-30/2 , 9-0-0/0 , 50-0-60/0
1-0-30/3 , 2-0-50/3 , 50-0-60/1
_/FILE-rung_0.csv
_/FILES_CLASSICLADDER
