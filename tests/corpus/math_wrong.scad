echo(abs(), abs(1, 2), abs("a"), sqrt(undef), pow(2), pow("a", 1), log(), log(1, 2, 3), log("a"), sin("a"), sin(), atan2(1), atan2("a", 1), exp([1]), floor(true));
