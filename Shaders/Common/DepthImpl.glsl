  gl_FragDepth = depthOf(mesoHitVC);
