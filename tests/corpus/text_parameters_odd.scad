for (d = ["ltr", "rtl", "ttb", "btt", "LTR", "right", "up", "l", "", "x", 5, undef]) { text("abc", direction = d); text("א", direction = d); text("", direction = d); }
for (s = ["Latn", "latn", "latin", "lat", "la", "l", "", "arab", "zzzz", "HANI", "greek", 7, "1234", "Hebr"]) { text("abc", script = s); text("1", script = s); }
for (l = ["en", "de-DE", "", "x", "zh_TW", 4]) text("abc", language = l);
for (h = ["left", "center", "right", "middle", "", 4, undef], v = ["baseline", "top", "center", "bottom", "", 4]) text("a", halign = h, valign = v);
