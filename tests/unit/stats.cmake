# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(surface_topology LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/surface_topology_test.cpp LINK hitscope_mesh)
hitscope_test(surface_measures LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/surface_measures_test.cpp LINK hitscope_mesh)
