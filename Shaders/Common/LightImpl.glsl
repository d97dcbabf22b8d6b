  mesoDiffuse = vec3(0.0);
  mesoSpecular = vec3(0.0);
  vec3 radiance;
//MESO::Lights
  blockLights();
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
