# meso_kernel_copies(<headers-variable> KERNELS <file>...)
#   Makes Meso<name>Float.h and Meso<name>Double.h in the build folder from each <name>.glsl,
#   whenever one of the kernels (each may need any other) or the step itself changes.
set(_mesoKernelStep "${CMAKE_CURRENT_LIST_DIR}")

function (meso_kernel_copies headersVariable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "KERNELS")
  set(headers)
  foreach (kernel IN LISTS arg_KERNELS)
    get_filename_component(name "${kernel}" NAME_WE)
    set(float "${CMAKE_CURRENT_BINARY_DIR}/Meso${name}Float.h")
    set(double "${CMAKE_CURRENT_BINARY_DIR}/Meso${name}Double.h")
    add_custom_command(
      OUTPUT "${float}" "${double}"
      COMMAND "${CMAKE_COMMAND}"
        "-DKERNEL=${kernel}"
        "-DFLOAT=${float}"
        "-DDOUBLE=${double}"
        -P "${_mesoKernelStep}/KernelToCxx.cmake"
      DEPENDS
        ${arg_KERNELS}
        "${_mesoKernelStep}/KernelRules.cmake"
        "${_mesoKernelStep}/KernelToCxx.cmake"
        "${_mesoKernelStep}/KernelTokens.cmake"
      COMMENT "Making C++ of ${name}.glsl"
      VERBATIM)
    list(APPEND headers "${float}" "${double}")
  endforeach ()
  set("${headersVariable}" "${headers}" PARENT_SCOPE)
endfunction ()
