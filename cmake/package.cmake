# `cpack -G DEB` in the build folder: one package for Debian 12 with program, libraries and headers.
set(CPACK_PACKAGE_NAME penumbra)
set(CPACK_PACKAGE_VENDOR penumbra)
set(CPACK_PACKAGE_CONTACT "the authors of penumbra <noreply@invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "soft shadows at the price of hard ones")
set(CPACK_PACKAGE_DESCRIPTION
"Renders scenes with area lights, and says which part of a light points see:
each is first proven lit or in umbra, and rays are traced only where neither
is proven. Program, C++ and C library, headers.")
set(CPACK_GENERATOR TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/library)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS gnuplot-nox)  # draws the plots of `penumbra reproduce`
if(TARGET penumbra_python)
  # Program and libraries work without Python, so nothing depends on it; the module is of one version.
  set(python ${Python3_VERSION_MAJOR})
  set(minor ${Python3_VERSION_MINOR})
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
    "python3 (>= ${python}.${minor}), python3 (<< ${python}.${next}), python3-numpy")
endif()
include(CPack)
