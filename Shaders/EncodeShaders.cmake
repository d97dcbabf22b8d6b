# meso_encode_shaders(<header-variable> <sources-variable> NAMES <file>...)
#   Turns files of this folder into C strings and writes the header MesoShaderTable.h, which lists
#   them under their names relative to this folder ("Common/Lighting.glsl").
set(_mesoShaderFolder "${CMAKE_CURRENT_LIST_DIR}")

function (meso_encode_shaders headerVariable sourcesVariable)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "NAMES")
  set(sources)
  set(includes)
  set(rows)
  foreach (name IN LISTS arg_NAMES)
    string(REGEX REPLACE "[/.]" "" symbol "mesoShader${name}")
    vtk_encode_string(
      INPUT "${_mesoShaderFolder}/${name}"
      NAME "${symbol}"
      EXPORT_SYMBOL "MESORENDERINGMESOSTRUCTURE_NO_EXPORT"
      EXPORT_HEADER "mesoRenderingMesostructureModule.h"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source)
    list(APPEND sources "${source}" "${header}")
    string(APPEND includes "#include \"${symbol}.h\"\n")
    string(APPEND rows "  { \"${name}\", ${symbol} },\n")
  endforeach ()
  set(table "${CMAKE_CURRENT_BINARY_DIR}/MesoShaderTable.h")
  file(CONFIGURE OUTPUT "${table}" @ONLY CONTENT
"#ifndef MesoShaderTable_h
#define MesoShaderTable_h
// Generated from the folder Shaders/.
@includes@
static const struct
{
  const char* Name;
  const char* Text;
} MesoShaderTable[] = {
@rows@};
#endif
")
  set("${headerVariable}" "${table}" PARENT_SCOPE)
  set("${sourcesVariable}" "${sources}" PARENT_SCOPE)
endfunction ()
