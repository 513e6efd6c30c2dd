if cube();
