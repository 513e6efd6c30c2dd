module r(n) { r(n+1); }
r(1);
