# dapple_module(NAME SOURCES ... [USES module ...] [LIBRARIES lib ...])
# One module: a static library dapple_NAME whose includes are written from src/.
function(dapple_module name)
  cmake_parse_arguments(M "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  add_library(dapple_${name} STATIC ${M_SOURCES})
  target_include_directories(dapple_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src
                                                   ${PROJECT_SOURCE_DIR}/include)
  list(TRANSFORM M_USES PREPEND dapple_)
  target_link_libraries(dapple_${name} PUBLIC ${M_USES} PRIVATE dapple_flags ${M_LIBRARIES})
endfunction()
