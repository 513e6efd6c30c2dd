echo(true&&false, true||false, 1&&"a", 0||"", []||[0], undef||0, !undef, !"", !"a", ![], ![0]);
echo(true ? 1 : 2, "" ? 1 : 2, 0/0 ? "nan is true" : "no", [0:1] ? "range" : 0);
function say(x) = echo(x) x;
echo(false && say("not reached"), true || say("nor this"), true && say("this"));
