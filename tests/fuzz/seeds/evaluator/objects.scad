o = object(a = 1, [["b", 2], ["a"]], f = function(this, x) this.b * x);
echo(o, o.f(3), o["b"], has_key(o, "a"), [for (k = o) k], object(o, c = o) == o, len(o), o.zz, [1, 2].yx);
echo(import("x.json"), textmetrics("a"), fontmetrics());
