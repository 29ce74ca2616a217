# What another project gets by find_package(nutshell):
#   nutshell::nutshell    all headers and compiled kernels, no flags forced
#   nutshell::same_bits   the same, with the flags under which g++ and clang give the same bits
# The two compile Eigen differently, sizes of its types included: a program takes one or the other, never both.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_target_property(options same_bits INTERFACE_COMPILE_OPTIONS)
get_target_property(definitions same_bits INTERFACE_COMPILE_DEFINITIONS)
add_library(package_same_bits INTERFACE)
target_compile_options(package_same_bits INTERFACE ${options})
target_compile_definitions(package_same_bits INTERFACE ${definitions})
target_link_libraries(package_same_bits INTERFACE nutshell)
set_target_properties(package_same_bits PROPERTIES EXPORT_NAME same_bits)

set(exported nutshell package_same_bits)
if(TARGET kernels)
  list(APPEND exported kernels)
endif()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/nutshell)
install(TARGETS ${exported} EXPORT nutshell COMPONENT nutshell
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/nutshell COMPONENT nutshell
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT nutshell NAMESPACE nutshell:: DESTINATION ${package_dir} FILE nutshellTargets.cmake COMPONENT nutshell)
file(GLOB header_rooms CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/common/base/nutshell ${PROJECT_SOURCE_DIR}/common/math/nutshell
  ${PROJECT_SOURCE_DIR}/chapters/0*_*/nutshell)
foreach(room ${header_rooms})
  install(DIRECTORY ${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT nutshell FILES_MATCHING PATTERN "*.hpp"
    PATTERN write_file.hpp EXCLUDE)
endforeach()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/nutshellConfig.cmake.in ${CMAKE_BINARY_DIR}/cmake/nutshellConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/nutshellConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/cmake/nutshellConfig.cmake ${CMAKE_BINARY_DIR}/cmake/nutshellConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT nutshell)
