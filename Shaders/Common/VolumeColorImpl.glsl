  vec3 mesoMatterColor = colorOfMatter();
  ambientColor *= mesoMatterColor;
  diffuseColor *= mesoMatterColor;
