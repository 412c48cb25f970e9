# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(core LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/mesh_core_test.cpp LINK hitscope_core)
foreach(name data primitives render teapot topology triangulate true_normals)
  hitscope_test(mesh_${name} LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/mesh_${name}_test.cpp LINK hitscope_mesh)
endforeach()
hitscope_test(deform LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/deform_test.cpp LINK hitscope_deform)
hitscope_test(deform_hit LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/deform_hit_test.cpp LINK hitscope_deform)
hitscope_test(deform_reach LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/deform_reach_test.cpp LINK hitscope_deform)
hitscope_test(deform_mesh LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/deform_mesh_test.cpp LINK hitscope_deform)
