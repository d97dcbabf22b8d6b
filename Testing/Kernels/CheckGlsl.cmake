# Fails unless glslangValidator takes KERNEL as GLSL 1.50 in a fragment shader, after the accessors that
# kernels stand on and the kernels that its lines "// Needs A.glsl" name.
cmake_minimum_required(VERSION 3.20)
set(accessors "")
foreach (name IN ITEMS Height Cone Base GDM GDMFactors GDMWhole Volume)
  list(APPEND accessors "${CMAKE_CURRENT_LIST_DIR}/../../Shaders/Common/${name}Access.glsl")
endforeach ()
set(order "")
macro (add_kernel file)
  file(STRINGS "${file}" needs REGEX "^// Needs ")
  string(REGEX MATCHALL "[A-Za-z0-9_]+[.]glsl" needs "${needs}")
  get_filename_component(folder "${file}" DIRECTORY)
  foreach (need IN LISTS needs)
    if (NOT "${folder}/${need}" IN_LIST order)
      add_kernel("${folder}/${need}")
    endif ()
  endforeach ()
  list(APPEND order "${file}")
endmacro ()
add_kernel("${KERNEL}")

# What the accessors stand on: defines, and a uniform of Common/Surface.glsl.
set(shader "#version 150\n#define MESO_WRAP 0\n#define MESO_GDM_GROUPS 1\nuniform vec2 mesoTiles;\n")
foreach (file IN LISTS accessors order)
  file(READ "${file}" text)
  string(APPEND shader "${text}")
endforeach ()
string(APPEND shader "out vec4 color;\nvoid main()\n{\n  color = vec4(0.0);\n}\n")
get_filename_component(name "${KERNEL}" NAME_WE)
file(WRITE "${FOLDER}/${name}.frag" "${shader}")
execute_process(
  COMMAND "${GLSLANG_VALIDATOR}" "${FOLDER}/${name}.frag"
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
if (NOT status EQUAL 0 OR output MATCHES "WARNING")
  message(FATAL_ERROR "${output}")
endif ()
