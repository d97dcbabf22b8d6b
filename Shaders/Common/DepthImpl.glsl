  gl_FragDepth = depthOf(mesoHitVC);
//MESO::CoincidentDepth
