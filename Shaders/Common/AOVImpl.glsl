#ifdef MESO_SURFACE
  gl_FragData[1] = vec4(mesoViewToWorld * mesoHit.NormalVC, 1.0);
  gl_FragData[2] = vec4(-mesoHitVC.z, mesoHit.MapCoord, mesoHit.Relief);
  vec4 mesoCounts =
    vec4(mesoObject, float(mesoHit.Fetches), float(mesoHit.TexelReads), float(mesoHit.Iterations));
  vec4 mesoShadows[3] = vec4[3](vec4(0.0), vec4(0.0), vec4(0.0));
#ifdef MESO_LIGHTING
  mesoCounts += vec4(0.0, float(mesoShadowFetches), 4.0 * float(mesoShadowFetches), 0.0);
  mesoShadows[0] = blockedFrom(0);
  mesoShadows[1] = blockedFrom(4);
  mesoShadows[2] = blockedFrom(8);
#endif
  gl_FragData[3] = mesoCounts;
  gl_FragData[4] = mesoShadows[0];
  gl_FragData[5] = mesoShadows[1];
  gl_FragData[6] = mesoShadows[2];
#else
  gl_FragData[1] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_FragData[2] = vec4(viewDistance(gl_FragCoord.z), 0.0, 0.0, 0.0);
  gl_FragData[3] = vec4(mesoObject, 0.0, 0.0, 0.0);
  gl_FragData[4] = vec4(0.0);
  gl_FragData[5] = vec4(0.0);
  gl_FragData[6] = vec4(0.0);
#endif
