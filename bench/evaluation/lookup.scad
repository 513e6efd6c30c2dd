// Tables: lookup, search, string keys.
table = [for (i = [0 : 99]) [i, sin(i)]];
names = [for (i = [0 : 199]) [str("key", i), i * i]];
values = [for (i = [0 : 150000]) lookup(i % 99 + 0.5, table)];
hits = [for (i = [0 : 30000]) names[search([str("key", i % 200)], names)[0]][1]];
letters = [for (i = [0 : 30000]) search("hello", "abcdefghijklmnopqrstuvwxyz")];
function max_of(v) = max([for (x = v) abs(x)]);
echo(max_of(values), max_of(hits), len(letters), letters[7]);
