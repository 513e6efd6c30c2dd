echo(1 && "a", 0 || [], !"" , ![], !undef, !0, "a" && undef, undef || 1, true ? 1 : x, false && x, true || x);
