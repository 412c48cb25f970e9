# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(physics LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/physics_test.cpp LINK hitscope_physics)
hitscope_test(physics_flights LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/physics_flights_test.cpp LINK hitscope_physics)
hitscope_test(camera LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/camera_test.cpp LINK hitscope_render hitscope_physics)
hitscope_test(changed_parts LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/changed_parts_test.cpp LINK hitscope_render)
