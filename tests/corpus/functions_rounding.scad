echo(abs(-3), sign(0/0), sign(-0), ceil(-1.5), floor(-1.5), round(-2.5), round(2.5), sqrt(-1), exp(1), ln(0), log(100), log(2,8), pow(2,0.5), pow(-8,1/3), abs("a"), abs(), abs(1,2), sqrt([4]));
