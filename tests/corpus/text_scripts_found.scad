// the script is told where all letters that have one agree
for (t = ["abc", "aλ", "λa", "aλa", "1 a", "a, 世", "世界", "123", "", " ", "שלום", "שלום a", "مرحبا", "Дa", "Д", "ひカ", "é", "à", "٣", "ⅷ"]) text(t);
text("aλ", script = "Grek");
text("λ", script = "latin");
text("abc", script = "");
text("abc", direction = "rtl", language = "de");
text("abc", direction = "up", halign = "middle", valign = "what", spacing = -1);
text(42); text(undef); text(true); text([1, "a"]); text("a", 0); text("a", -3); text("a", "b"); text(size = 3); text("x", font = 3);
