int five = 5;
