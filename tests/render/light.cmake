# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(lights LABEL render
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/lights_test.cpp ${CMAKE_CURRENT_LIST_DIR}/render_support.cpp
  LINK hitscope_render Qt6::Gui)

hitscope_test(modes LABEL render
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/modes_test.cpp ${CMAKE_CURRENT_LIST_DIR}/render_support.cpp
  LINK hitscope_render Qt6::Gui)
target_compile_definitions(test_render_modes PRIVATE HITSCOPE_BASELINES="${CMAKE_CURRENT_LIST_DIR}/baselines")
