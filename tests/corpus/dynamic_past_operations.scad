module m() { echo($fn, $foo); } m($foo=3); m(); translate($foo=4) m(); union($fn=12) m(); if (true) { $foo=8; m(); } m();
