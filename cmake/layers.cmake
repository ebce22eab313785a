# One folder of penumbra/ = one target = one layer. A layer links only what stands above it.

# Compiler settings that are part of the product: a picture is a test result, so no contraction to fused
# multiply-adds and no fast-math. The two others change no result, only what may be vectorised.
add_library(penumbra_settings INTERFACE)
target_compile_features(penumbra_settings INTERFACE cxx_std_20)
target_compile_options(penumbra_settings INTERFACE
  -ffp-contract=off -fno-math-errno -fno-trapping-math -Wall -Wextra -Wpedantic -Wshadow
  $<$<BOOL:${PENUMBRA_WERROR}>:-Werror>)
target_compile_definitions(penumbra_settings INTERFACE $<$<BOOL:${PENUMBRA_ASSERTS}>:PENUMBRA_ASSERTS=1>)

# penumbra_layer(shadow SOURCES … HEADERS … USES kernel scene LIBRARIES … PRECOMPILE …)
# HEADERS are the layer's public ones; LIBRARIES are private, and so is what of them to PRECOMPILE.
function(penumbra_layer name)
  cmake_parse_arguments(L "" "" "SOURCES;HEADERS;USES;LIBRARIES;PRECOMPILE" ${ARGN})
  add_library(penumbra_${name} STATIC ${L_SOURCES})
  add_library(penumbra::${name} ALIAS penumbra_${name})
  target_precompile_headers(penumbra_${name} PRIVATE ${L_PRECOMPILE})
  # Each header must compile alone. The source of its name shows that, as it includes it first (which
  # tests/check_layers.py holds it to), but for those who get others before it.
  set(shown ${L_SOURCES})
  list(TRANSFORM shown REPLACE "cpp$" "h")
  set(to_verify ${L_HEADERS})
  if(NOT L_PRECOMPILE)
    list(REMOVE_ITEM to_verify ${shown})
  endif()
  list(REMOVE_ITEM L_HEADERS ${to_verify})
  target_sources(penumbra_${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${L_HEADERS}
    FILE_SET to_verify TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${to_verify})
  set_target_properties(penumbra_${name} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY to_verify)
  target_compile_features(penumbra_${name} PUBLIC cxx_std_20)
  target_link_libraries(penumbra_${name} PRIVATE penumbra_settings ${L_LIBRARIES})
  set_target_properties(penumbra_${name} PROPERTIES PENUMBRA_LIBRARIES "${L_LIBRARIES}")
  list(TRANSFORM L_USES PREPEND penumbra::)
  target_link_libraries(penumbra_${name} PUBLIC ${L_USES})
endfunction()

# penumbra_shared(visibility NAME penumbra LAYERS … HEADERS … GENERATED … USES …): a library to install,
# made of the layers' own objects, for find_package's target penumbra::<component>. HEADERS, and those that
# were GENERATED, are all that it installs. USES are other such components, whose layers it takes from there.
function(penumbra_shared component)
  cmake_parse_arguments(S "" "NAME" "LAYERS;HEADERS;GENERATED;USES" ${ARGN})
  set(target penumbra_shared_${component})
  add_library(${target} SHARED)
  # Until 1.0 a minor version may break what was.
  set(abi ${PROJECT_VERSION_MAJOR})
  if(abi EQUAL 0)
    set(abi 0.${PROJECT_VERSION_MINOR})
  endif()
  set(exports ${PROJECT_SOURCE_DIR}/cmake/exports.map)
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${S_NAME} EXPORT_NAME ${component} VERSION ${PROJECT_VERSION} SOVERSION ${abi}
    LINKER_LANGUAGE CXX INSTALL_RPATH "\$ORIGIN" LINK_DEPENDS ${exports})
  target_compile_features(${target} INTERFACE cxx_std_20)
  # Calls within the library are bound when it is linked, as they are in a program.
  target_link_options(${target} PRIVATE -Wl,-Bsymbolic-functions -Wl,--version-script=${exports})
  foreach(layer IN LISTS S_LAYERS)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:penumbra_${layer}>)
    get_target_property(libraries penumbra_${layer} PENUMBRA_LIBRARIES)
    target_link_libraries(${target} PRIVATE ${libraries})
  endforeach()
  list(TRANSFORM S_USES PREPEND penumbra_shared_)
  target_link_libraries(${target} PUBLIC ${S_USES})
  target_sources(${target} INTERFACE
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${S_HEADERS}
    FILE_SET generated TYPE HEADERS BASE_DIRS ${PENUMBRA_GENERATED_DIR} FILES ${S_GENERATED})
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)  # tests/consumer does
endfunction()
