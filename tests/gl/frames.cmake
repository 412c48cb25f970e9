# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(timer_queries LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/timer_queries_test.cpp ${PROJECT_SOURCE_DIR}/tests/support/gl_fixture.cpp
  LINK hitscope_gl)
hitscope_test(frame_costs LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/frame_costs_test.cpp ${PROJECT_SOURCE_DIR}/tests/support/gl_fixture.cpp
  LINK hitscope_session)
hitscope_test(cost_measurement LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/cost_measurement_test.cpp LINK hitscope_session)
