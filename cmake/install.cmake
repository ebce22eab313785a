# What `cmake --install` puts where. Everything finds everything else by relative paths, so that a
# prefix may be moved. Component `runtime` is what programs need, `development` what building them
# needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/penumbra)
foreach(component visibility render)
  install(TARGETS penumbra_shared_${component} EXPORT penumbra-${component}
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
    FILE_SET HEADERS COMPONENT development
    FILE_SET generated COMPONENT development)
  install(EXPORT penumbra-${component} NAMESPACE penumbra:: DESTINATION ${package_dir}
    FILE penumbra-${component}-targets.cmake COMPONENT development)
endforeach()

set(made ${PROJECT_BINARY_DIR}/generated)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/penumbra-config.cmake.in
  ${made}/penumbra-config.cmake INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${made}/penumbra-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${made}/penumbra-config.cmake ${made}/penumbra-config-version.cmake
  DESTINATION ${package_dir} COMPONENT development)

# pkg-config's files name paths relative to themselves.
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pc /prefix/${pc_dir} /prefix)
foreach(name penumbra penumbra-render)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in ${made}/${name}.pc @ONLY)
  install(FILES ${made}/${name}.pc DESTINATION ${pc_dir} COMPONENT development)
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  install(TARGETS penumbra_app RUNTIME COMPONENT runtime)
  install(DIRECTORY ${made}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT runtime)
  # Where the shells look, below any prefix.
  set(shells ${CMAKE_INSTALL_DATADIR})
  install(FILES ${made}/completion/bash DESTINATION ${shells}/bash-completion/completions
    RENAME penumbra COMPONENT runtime)
  # Packages have a place of their own, which zsh looks into below /usr alone.
  install(CODE "
    set(penumbra_zsh_dir site-functions)
    if(CMAKE_INSTALL_PREFIX MATCHES \"/usr$\")  # also where cpack gathers a package
      set(penumbra_zsh_dir vendor-completions)
    endif()" COMPONENT runtime)
  install(FILES ${made}/completion/zsh DESTINATION "${shells}/zsh/\${penumbra_zsh_dir}"
    RENAME _penumbra COMPONENT runtime)
  install(FILES ${made}/completion/fish DESTINATION ${shells}/fish/vendor_completions.d
    RENAME penumbra.fish COMPONENT runtime)
  install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT runtime)  # Debian's name for it
  install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT runtime)
  install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
    PATTERN __pycache__ EXCLUDE)

  # All of the above and no tests: `cmake --build build --target installable`.
  add_custom_target(installable DEPENDS
    penumbra_app penumbra_manual penumbra_shared_visibility penumbra_shared_render
    $<TARGET_NAME_IF_EXISTS:penumbra_python>)
endif()
