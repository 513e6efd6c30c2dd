$vpr = [10, 20, 30]; $vpt = [1, 2, 3]; $vpd = 100; $vpf = 30; echo($vpr, $vpt, $vpd, $vpf); cube();
