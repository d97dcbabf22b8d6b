#ifndef MesoForeignShadows_h
#define MesoForeignShadows_h

#include <string>

/**
 * Let VTK's own lighting, Phong's or the physical one, take shadows: in a fragment shader that has it,
 * each light's colour is dimmed by castFraction of Shaders/Common/ShadowMapDec.glsl. A shader without
 * lighting stays as it is.
 */
std::string MesoShadeForeignLighting(const std::string& fragment, int numberOfLights);

#endif
