# SPDX-License-Identifier: GPL-3.0-or-later
# Everything Hitscope stands on; the Debian packages are listed in packaging/dependencies.
set(QT_NO_PRIVATE_MODULE_WARNING ON)
find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets OpenGLWidgets PrintSupport Test)
qt_standard_project_setup()
find_package(glm REQUIRED)
find_package(assimp REQUIRED)
find_package(tinyobjloader REQUIRED)
find_path(TINYGLTF_INCLUDE tiny_gltf.h REQUIRED)          # it reads back the glTF that we wrote
find_path(NLOHMANN_JSON_INCLUDE nlohmann/json.hpp REQUIRED)  # its own need
find_package(OpenMesh REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(QCustomPlotQt6 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(seccomp REQUIRED IMPORTED_TARGET libseccomp)
pkg_check_modules(crypto REQUIRED IMPORTED_TARGET libcrypto)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # What ccache needs to know of precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
endif()

# Other people's headers are not held to our warnings.
foreach(dependency glm::glm assimp::assimp tinyobjloader::tinyobjloader tinyobjloader::tinyobjloader_double
                   QCustomPlotQt6::QCustomPlotQt6 PkgConfig::bullet PkgConfig::epoxy OpenMeshCore OpenMeshTools
                   meshoptimizer::meshoptimizer)
  if(TARGET ${dependency})
    get_target_property(folders ${dependency} INTERFACE_INCLUDE_DIRECTORIES)
    if(folders)
      set_target_properties(${dependency} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${folders}")
    endif()
  endif()
endforeach()
