  gl_FragData[0].rgb = mix(gl_FragData[0].rgb, mesoContourColor, contoursAtHit());
#ifndef MESO_DISPLACED
  mesoHit.Fetches += 1;
  mesoHit.TexelReads += 4;
#endif
