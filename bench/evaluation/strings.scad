// Text put together and taken apart.
function join(list, by = "") = [for (i = 0, s = ""; i <= len(list); s = i < len(list) ? str(s, i == 0 ? "" : by, list[i]) : s, i = i + 1) s][len(list)];
function repeat(s, n, done = "") = n == 0 ? done : repeat(s, n - 1, str(done, s));
function upper(s) = join([for (c = s) let (o = ord(c)) o >= 97 && o <= 122 ? chr(o - 32) : c]);
function split(s, by) = let (at = concat([-1], [for (i = [0 : len(s) - 1]) if (s[i] == by) i], [len(s)]))
    [for (k = [0 : len(at) - 2]) join([for (i = at[k] + 1; i < at[k + 1]; i = i + 1) s[i]])];
numbers = join([for (i = [0 : 1499]) i], ",");
parts = split(numbers, ",");
rows = [for (i = [0 : 29999]) str("row ", i, ": ", i / 7, " [", i * i, "]")];
echo(len(numbers), len(parts), len(upper(numbers)), len(repeat("ab", 3000)), len(join([for (i = [0 : 5999]) rows[i]])), len(rows));
