f = function (x) x; v = [1]; assert(!(f(v[0]) == 1 ? true : false) || v.y > -1 && len("s") < 0);
