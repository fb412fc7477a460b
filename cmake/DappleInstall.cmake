# What `cmake --install` puts in place: programs with manual pages and completions, library,
# headers, CMake package, pkg-config file.
include(CMakePackageConfigHelpers)

set(DAPPLE_PROGRAMS ray ray_bvh store_scene describe_scene dapple_command)
install(TARGETS ${DAPPLE_PROGRAMS} RUNTIME COMPONENT programs)

# The programs can be started from the source folder as ./NAME.
if(DAPPLE_ROOT_LINKS)
  foreach(program IN LISTS DAPPLE_PROGRAMS)
    get_target_property(folder ${program} BINARY_DIR)
    string(REPLACE _command "" name ${program})
    file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${folder}/${name})
    file(CREATE_LINK ${path} ${PROJECT_SOURCE_DIR}/${name} SYMBOLIC)
  endforeach()
endif()

# The build writes these beside the programs (apps/docs).
set(completions ${PROJECT_BINARY_DIR}/completions)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
        COMPONENT programs)
install(FILES ${completions}/dapple.bash RENAME dapple
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
install(FILES ${completions}/_dapple
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT programs)
install(FILES ${completions}/dapple.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
install(FILES LICENSE README.md CHANGELOG.md TYPE DOC COMPONENT programs)

install(TARGETS dapple EXPORT dappleTargets
        LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/dapple TYPE INCLUDE COMPONENT development)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/dapple)
install(EXPORT dappleTargets NAMESPACE dapple:: DESTINATION ${package_dir} COMPONENT development)
configure_package_config_file(cmake/dappleConfig.cmake.in dappleConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(dappleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dappleConfig.cmake
              ${PROJECT_BINARY_DIR}/dappleConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT development)

# pkg-config: paths relative to the file itself, so that the installation can be moved.
file(RELATIVE_PATH DAPPLE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" DAPPLE_PC_PREFIX "${DAPPLE_PC_PREFIX}")
configure_file(cmake/dapple.pc.in dapple.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/dapple.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
