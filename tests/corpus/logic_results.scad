echo(1 && 2, 0 || "a", 0 || "", !"a", !undef, [] || false, undef && true);
echo(3 || (assert(false) 1), false && (assert(false) 1), true ? 1 : assert(false));
