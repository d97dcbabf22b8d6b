# Runs the step STEP on KERNEL and fails unless it refuses exactly the lines that say so:
#   v.xy = w; // Refused: write to the swizzle .xy
# with the reason (its beginning; two such comments for two reasons) and the right line, with a
# failing exit status and without writing a copy. @NON_ASCII@ stands for a letter that this
# project's files do not hold.
cmake_minimum_required(VERSION 3.20)
get_filename_component(name "${KERNEL}" NAME)
file(READ "${KERNEL}" text)
string(ASCII 195 169 NON_ASCII)
string(REPLACE "@NON_ASCII@" "${NON_ASCII}" text "${text}")
file(WRITE "${FOLDER}/${name}" "${text}")

set(wanted "")
set(line 0)
while (NOT text STREQUAL "")
  math(EXPR line "${line} + 1")
  string(FIND "${text}" "\n" end)
  string(SUBSTRING "${text}" 0 ${end} row)
  math(EXPR end "${end} + 1")
  string(SUBSTRING "${text}" ${end} -1 text)
  while (row MATCHES "(.*) // Refused: (.*)$")
    set(row "${CMAKE_MATCH_1}")
    string(APPEND wanted "${FOLDER}/${name}:${line}: error: ${CMAKE_MATCH_2}\n")
  endwhile ()
endwhile ()
if (wanted STREQUAL "")
  message(FATAL_ERROR "${KERNEL} does not say what is refused")
endif ()

# What a refused kernel may need.
file(COPY "${CMAKE_CURRENT_LIST_DIR}/AcceptedNeeded.glsl" DESTINATION "${FOLDER}")
file(REMOVE "${FOLDER}/${name}.float.h" "${FOLDER}/${name}.double.h")
execute_process(
  COMMAND "${CMAKE_COMMAND}"
    "-DKERNEL=${FOLDER}/${name}"
    "-DFLOAT=${FOLDER}/${name}.float.h"
    "-DDOUBLE=${FOLDER}/${name}.double.h"
    -P "${STEP}"
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
if (status EQUAL 0)
  message(FATAL_ERROR "Accepted, but should be refused:\n${wanted}")
endif ()
file(GLOB copies "${FOLDER}/${name}.*.h*")
if (copies)
  message(FATAL_ERROR "Refused, but wrote ${copies}")
endif ()

# Both lists, row by row.
set(rest "${output}")
while (NOT wanted STREQUAL "")
  string(FIND "${wanted}" "\n" end)
  string(SUBSTRING "${wanted}" 0 ${end} row)
  math(EXPR end "${end} + 1")
  string(SUBSTRING "${wanted}" ${end} -1 wanted)
  string(FIND "${rest}" "${row}" start)
  if (start EQUAL -1)
    message(FATAL_ERROR "Wanted the line\n${row}...\ngot\n${output}")
  endif ()
  string(SUBSTRING "${rest}" ${start} -1 tail)
  string(SUBSTRING "${rest}" 0 ${start} rest)
  string(FIND "${tail}" "\n" end)
  string(SUBSTRING "${tail}" ${end} -1 tail)
  string(APPEND rest "${tail}")
endwhile ()
if (rest MATCHES ": error: ")
  message(FATAL_ERROR "Refused more than it should:\n${rest}")
endif ()
