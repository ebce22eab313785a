# Gemmi's Debian package (0.5) ships headers without a CMake configuration.
find_path(Gemmi_INCLUDE_DIR gemmi/model.hpp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Gemmi REQUIRED_VARS Gemmi_INCLUDE_DIR)
if(Gemmi_FOUND AND NOT TARGET Gemmi::headers)
  add_library(Gemmi::headers INTERFACE IMPORTED)
  target_include_directories(Gemmi::headers INTERFACE ${Gemmi_INCLUDE_DIR})
endif()
