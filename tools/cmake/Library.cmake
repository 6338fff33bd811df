# The library for other projects, slicecast::slicecast: one archive that holds the engine, and the
# headers of src/include. It needs nothing of the system but the C++ library, and its users see
# neither the engine's own headers nor its flags.
file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/library/*.cpp)
add_library(slicecast_library STATIC ${sources})
add_library(slicecast::slicecast ALIAS slicecast_library)
foreach(part base world scene render classic overlay session answers files)
  target_sources(slicecast_library PRIVATE $<TARGET_OBJECTS:slicecast_${part}>)
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/version.h.in ${PROJECT_BINARY_DIR}/include/slicecast/version.h @ONLY)
target_compile_features(slicecast_library PUBLIC cxx_std_20)
target_include_directories(slicecast_library BEFORE
  PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
  PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(slicecast_library PRIVATE $<BUILD_INTERFACE:slicecast_flags> $<BUILD_INTERFACE:slicecast_strict>)
set_target_properties(slicecast_library PROPERTIES OUTPUT_NAME slicecast EXPORT_NAME slicecast)

# For find_package(slicecast) and pkg-config. Inside another project nothing is installed by default.
option(SLICECAST_INSTALL "Install the library" ${PROJECT_IS_TOP_LEVEL})
if(NOT SLICECAST_INSTALL)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/slicecast)
install(TARGETS slicecast_library EXPORT slicecast COMPONENT slicecast
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/include/slicecast ${PROJECT_BINARY_DIR}/include/slicecast COMPONENT slicecast
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT slicecast
  DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/slicecast)
install(EXPORT slicecast COMPONENT slicecast
  NAMESPACE slicecast:: FILE slicecastConfig.cmake DESTINATION ${package})
# Before 1.0 a new minor version may change declarations.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slicecastConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slicecastConfigVersion.cmake COMPONENT slicecast
  DESTINATION ${package})
# Relative to itself, so that the folder may be moved.
set(packages ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefixOfPackage /prefix/${packages} /prefix)
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/slicecast.pc.in ${PROJECT_BINARY_DIR}/slicecast.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/slicecast.pc COMPONENT slicecast DESTINATION ${packages})
