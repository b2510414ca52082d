char other_s[] = "华";
