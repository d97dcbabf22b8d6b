// What Common/PrismAccess stands on, where it is in the vertex stage.
uniform int cameraParallel; // VTK's
uniform vec2 mesoTiles;
