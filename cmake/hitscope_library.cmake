# SPDX-License-Identifier: GPL-3.0-or-later

# What every target of ours is compiled with. Results must not depend on the compiler's mood: -ffp-contract=off keeps the
# deformation the same in every bit as the GPU's (HACKING.md: "Four rules").
add_library(hitscope_options INTERFACE)
target_compile_features(hitscope_options INTERFACE cxx_std_20)
target_include_directories(hitscope_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(hitscope_options INTERFACE
  -ffp-contract=off
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
  -Wformat=2 -Wnull-dereference -Wno-sign-conversion
  # GCC 12 sees overlaps and overflows in every "literal" + std::string (its bug 105651), and no longer knows a system's header
  # that was precompiled.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds
    -Wno-subobject-linkage>  # of files compiled as one
  # Clang 19 takes what the std::stable_sort of GCC 12's library uses for ours.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
  $<$<BOOL:${HITSCOPE_WERROR}>:-Werror>)
# Programs too, or they cannot use the precompiled headers of libraries: Debian 12's Qt asks for it, Debian 13's does not.
get_target_property(options_of_qt Qt6::Core INTERFACE_COMPILE_OPTIONS)
if(NOT "-fPIC" IN_LIST options_of_qt)
  target_compile_options(hitscope_options INTERFACE -fPIC)
endif()
target_compile_definitions(hitscope_options INTERFACE
  GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL QT_NO_KEYWORDS QT_NO_CAST_FROM_BYTEARRAY
  HITSCOPE_VERSION="${PROJECT_VERSION}")
if(HITSCOPE_SANITIZE STREQUAL "address")
  target_compile_options(hitscope_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC takes sanitized code for that
  target_link_options(hitscope_options INTERFACE -fsanitize=address,undefined)
elseif(HITSCOPE_SANITIZE STREQUAL "thread")
  target_compile_options(hitscope_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(hitscope_options INTERFACE -fsanitize=thread)
endif()
if(HITSCOPE_FUZZ AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_compile_options(hitscope_options INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(hitscope_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Headers cost more than our own code, so eight files of a folder are compiled as one: what they name for themselves must differ.
# Which eight does not depend on the version of CMake, whose own batches do. Not in the dev preset, where one file is built faster
# and a missing #include is seen.
function(hitscope_compile_together target)
  if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(number 0)
  foreach(source ${sources})
    math(EXPR group "${number} / 8")
    math(EXPR number "${number} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# hitscope_library(NAME SOURCES ... [LINK PUBLIC-libraries ...] [PRIVATE_LINK ...] [PRECOMPILED std|qt|widgets])
# One folder under src/ is one static library hitscope_NAME. What it may include is what it links: that is the rule of
# the house, so think before adding to LINK. PRECOMPILED: cmake/precompiled_headers.cmake, std if not said.
function(hitscope_library name)
  cmake_parse_arguments(arg "" "PRECOMPILED" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(hitscope_${name} STATIC ${arg_SOURCES})
  target_link_libraries(hitscope_${name} PUBLIC hitscope_options ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK})
  if(NOT arg_PRECOMPILED)
    set(arg_PRECOMPILED std)
  endif()
  target_precompile_headers(hitscope_${name} REUSE_FROM hitscope_precompiled_${arg_PRECOMPILED})
  hitscope_compile_together(hitscope_${name})
endfunction()
