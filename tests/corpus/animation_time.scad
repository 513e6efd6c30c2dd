echo($t, $t + 1); rotate($t * 360) cube();
