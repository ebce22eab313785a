# stb's Debian package ships headers without a CMake configuration.
find_path(Stb_INCLUDE_DIR stb/stb_image.h)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Stb REQUIRED_VARS Stb_INCLUDE_DIR)
if(Stb_FOUND AND NOT TARGET Stb::headers)
  add_library(Stb::headers INTERFACE IMPORTED)
  target_include_directories(Stb::headers INTERFACE ${Stb_INCLUDE_DIR})
endif()
