// A shadow map is drawn: its targets take depth along the light's axis, world units, and the number
// of what is met there.
//   MESO_SURFACE  the mapper is one of Meso's and has traced its surface along the light's ray
uniform float mesoCaster;
uniform vec2 mesoCasterRange; // near and far, of parallel views
