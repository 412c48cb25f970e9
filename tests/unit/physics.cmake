# SPDX-License-Identifier: GPL-3.0-or-later
foreach(test colliders dynamic hull time bounds)
  hitscope_test(physics_${test} LABEL unit LINK hitscope_physics
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/physics_${test}_test.cpp)
endforeach()
hitscope_test(physics_session LABEL unit LINK hitscope_session
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/physics_session_test.cpp)
