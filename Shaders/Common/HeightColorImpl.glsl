  vec3 mesoHeightColor = colorOfHeight(1.0 - mesoHit.Relief);
  ambientColor = ambientIntensity * mesoHeightColor;
  diffuseColor = diffuseIntensity * mesoHeightColor;
