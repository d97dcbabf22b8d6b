// VTK 9.1's Phong, term for term in VTK's order, so that a surface without relief comes out equal
// bit for bit; and for each light the fraction of it that the detail blocks.
//   MESO_SPECULAR     the material has a specular part (without one, VTK adds an exact zero)
//   MESO_SELF_SHADOW  detail blocks light
//   MESO_CAST_SHADOW  so does what lies beyond it (Common/ShadowMapDec)
//   MESO_FILTER       relief is averaged over pixels (Common/HeightSurface)

const float FarAway = 1.0e30; // of lights without a place

struct MesoLight
{
  vec3 TravelVC;     // unit: the way the light travels here
  float Attenuation; // distance and cone, 1 without
  float Distance;    // from here to the light
};

MesoLight mesoLights[MESO_LIGHT_COUNT];
vec3 mesoDiffuse;
vec3 mesoSpecular;
int mesoShadowFetches;
#if defined(MESO_SELF_SHADOW) || defined(MESO_CAST_SHADOW) || defined(MESO_AOV)
float mesoBlocked[MESO_LIGHT_COUNT]; // the fraction that does not arrive
#endif
#ifdef MESO_CAST_SHADOW
vec3 mesoFacetVC; // normal of the base mesh's triangle
float castFraction(
  int light, vec3 positionVC, vec3 facetVC, float below, float thickness, float followed);
#endif

// VTK's headlight is directional along the view axis.
MesoLight headlight()
{
  MesoLight light;
  light.TravelVC = vec3(0.0, 0.0, -1.0);
  light.Attenuation = 1.0;
  light.Distance = FarAway;
  return light;
}

MesoLight directionalLight(vec3 directionVC)
{
  MesoLight light;
  light.TravelVC = directionVC;
  light.Attenuation = 1.0;
  light.Distance = FarAway;
  return light;
}

MesoLight positionalLight(vec3 positionVC, int positional, vec3 lightDirectionVC,
  vec3 lightPositionVC, vec3 attenuation, float coneAngle, float exponent)
{
  MesoLight light;
  light.Attenuation = 1.0;
  light.Distance = FarAway;
  light.TravelVC = lightDirectionVC;
  if (positional != 0)
  {
    light.TravelVC = positionVC - lightPositionVC;
    float distanceVC = length(light.TravelVC);
    light.Distance = distanceVC;
    light.TravelVC = normalize(light.TravelVC);
    light.Attenuation =
      1.0 / (attenuation.x + attenuation.y * distanceVC + attenuation.z * distanceVC * distanceVC);
    if (coneAngle < 90.0)
    {
      float coneDot = dot(light.TravelVC, lightDirectionVC);
      if (coneDot >= cos(radians(coneAngle)))
      {
        light.Attenuation = light.Attenuation * pow(coneDot, exponent);
      }
      else
      {
        light.Attenuation = 0.0;
      }
    }
  }
  return light;
}

// Relief that has been averaged away shades as what it was (Common/HeightSurface).
#ifdef MESO_FILTER
bool averagedFaces(vec3 lightOutVC);
float averagedCosine(vec3 normalVC, vec3 lightOutVC);
#else
bool averagedFaces(vec3 lightOutVC)
{
  return false;
}
float averagedCosine(vec3 normalVC, vec3 lightOutVC)
{
  return dot(normalVC, lightOutVC);
}
#endif

#ifdef MESO_CAST_SHADOW
// The part of a light that something beyond the detail takes from a point.
float castOn(int light, vec3 positionVC)
{
  mesoShadowFetches += 1;
#if defined(MESO_SURFACE) && defined(MESO_PRISMS)
  vec3 way;
  float followed = lengthFollowed(-mesoLights[light].TravelVC, mesoLights[light].Distance, way);
  return castFraction(light, positionVC, mesoHit.FacetNormalVC, 0.0, 0.0, followed);
#elif defined(MESO_SURFACE) && defined(MESO_FRAME)
  float thickness = length(mesoFragment.PerDepth);
  return castFraction(light, positionVC, mesoFacetVC, mesoHit.Relief * thickness, thickness, 0.0);
#else
  return castFraction(light, positionVC, mesoFacetVC, 0.0, 0.0, 0.0);
#endif
}
#endif

// How much of each light does not arrive. A loop, since the shadow search written out for each
// light makes shaders that some compilers take a minute for.
void blockLights(vec3 positionVC)
{
  mesoShadowFetches = 0;
#if defined(MESO_SELF_SHADOW) || defined(MESO_CAST_SHADOW) || defined(MESO_AOV)
  for (int i = 0; i < MESO_LIGHT_COUNT; ++i)
  {
    float blocked = 0.0;
#if defined(MESO_SELF_SHADOW) || defined(MESO_AOV)
    float lightDistance = mesoLights[i].Distance;
#ifdef MESO_CLIPPED
    // What is cut away casts no shadow.
    lightDistance =
      clamp(keptStretch(mesoHitVC, -mesoLights[i].TravelVC).y, 0.0, lightDistance);
#endif
    // The facet's back has no light, whatever its interpolated normal says.
    blocked = 1.0;
    if (dot(mesoHit.FacetNormalVC, -mesoLights[i].TravelVC) > 0.0 ||
      averagedFaces(-mesoLights[i].TravelVC))
    {
      int fetches;
      blocked = blockedFraction(
        mesoFragment, mesoHit, -mesoLights[i].TravelVC, lightDistance, fetches);
      mesoShadowFetches += fetches;
    }
#endif
#ifdef MESO_CAST_SHADOW
    if (blocked < 1.0)
    {
      blocked = max(blocked, castOn(i, positionVC));
    }
#endif
    mesoBlocked[i] = blocked;
  }
#endif
}

// What is left of a light's radiance.
vec3 unblocked(int index, vec3 radiance)
{
#if defined(MESO_SELF_SHADOW) || defined(MESO_CAST_SHADOW)
  return (1.0 - mesoBlocked[index]) * radiance;
#else
  return radiance;
#endif
}

// A single headlight: VTK lights it by n.z alone.
void shadeHeadlight(vec3 radiance, vec3 normalVC, vec3 diffuseColor, float specularPower)
{
  radiance = unblocked(0, radiance);
  float df = max(0.0, averagedCosine(normalVC, vec3(0.0, 0.0, 1.0)));
  mesoDiffuse = df * diffuseColor * radiance;
#ifdef MESO_SPECULAR
  mesoSpecular = pow(max(0.0, normalVC.z), specularPower) * radiance;
#endif
}

void shade(int index, vec3 radiance, vec3 normalVC, vec3 positionVC, float specularPower)
{
  MesoLight light = mesoLights[index];
  radiance = unblocked(index, radiance);
  mesoDiffuse +=
    max(0.0, light.Attenuation * averagedCosine(normalVC, -light.TravelVC)) * radiance;
#ifdef MESO_SPECULAR
  // Of the mean alone: what is averaged away scatters none of it.
  float df = max(0.0, light.Attenuation * dot(normalVC, -light.TravelVC));
  float sf = sign(df) * light.Attenuation *
    pow(max(0.0, dot(reflect(light.TravelVC, normalVC), normalize(-positionVC))), specularPower);
  mesoSpecular += sf * radiance;
#endif
}
