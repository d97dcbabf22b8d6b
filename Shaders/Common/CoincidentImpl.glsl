  gl_FragDepth = clamp(gl_FragDepth + cOffset / 65000.0, 0.0, 1.0);
