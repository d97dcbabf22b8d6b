  mesoDiffuse = vec3(0.0);
  mesoSpecular = vec3(0.0);
  vec3 radiance;
//MESO::Lights
#if defined(MESO_CAST_SHADOW) && !defined(MESO_SURFACE)
  mesoFacetVC = facetOf(vertexVC.xyz, normalVCVSOutput);
#endif
  blockLights(vertexVC.xyz);
//MESO::Shading
  vec3 diffuse = mesoDiffuse;
  vec3 specular = vec3(0.0);
#ifndef MESO_HEADLIGHT
  diffuse = diffuse * diffuseColor;
#endif
#ifdef MESO_SPECULAR
  specular = mesoSpecular * specularColor;
#endif
  gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);
