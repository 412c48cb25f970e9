# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(change_map LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/change_map_test.cpp ${CMAKE_CURRENT_LIST_DIR}/../support/gl_fixture.cpp
  LINK hitscope_session)
hitscope_test(comparison LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/comparison_test.cpp ${CMAKE_CURRENT_LIST_DIR}/../support/gl_fixture.cpp
  LINK hitscope_session Qt6::Gui)
hitscope_test(before_after LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/before_after_test.cpp ${CMAKE_CURRENT_LIST_DIR}/../support/gl_fixture.cpp
  LINK hitscope_session Qt6::Gui)
